package haltere.filters.cluster;

/** The clusters that there are, in the order of their births. Thread rule: that of its owner. */
final class Clusters {
  /** As many as there may be. Behind the {@link #count} that there are: ones to be used again. */
  Cluster[] all = new Cluster[0];

  int count;

  /** Whether there have been others, or in another order, since this was last set to false. */
  boolean changed;

  boolean isFull() {
    return count == all.length;
  }

  /** One more, in which nothing is set yet. */
  Cluster add() {
    changed = true;
    return all[count++];
  }

  /** Takes a cluster out; the order of the others stays. */
  void remove(int index) {
    changed = true;
    Cluster removed = all[index];
    System.arraycopy(all, index + 1, all, index, count - index - 1);
    all[--count] = removed;
  }

  /** Changes how many there may be; where there are more, the latest born go. */
  void setMost(int most) {
    if (most == all.length) {
      return;
    }
    count = Math.min(count, most);
    Cluster[] old = all;
    all = new Cluster[most];
    boolean[] taken = new boolean[most];
    int kept = 0;
    for (int i = 0; i < count; i++) {
      if (old[i].slot < most) {
        taken[old[i].slot] = true;
        all[kept++] = old[i];
      }
    }
    count = kept;
    for (int slot = 0; slot < most; slot++) {
      if (!taken[slot]) {
        all[kept++] = new Cluster(slot);
      }
    }
  }
}
