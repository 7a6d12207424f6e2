package haltere.core.pipeline;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.event.EventPacket;
import haltere.core.sink.CsvSink;
import haltere.core.sink.LineOutput;
import haltere.core.sink.LiveMessages;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.internal.Daemon;
import java.io.Closeable;
import java.time.Clock;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * Sends the results of a running chain's filters, and the notifications of the stream, as {@link
 * LiveMessages}. A separate thread writes and sends the results; if it is too slow, the newest are
 * dropped and counted, and receivers are notified at their position. The chain is never blocked.
 * Without a receiver, messages are only numbered. Outlets whose results are not {@link
 * CsvSink#isFlat flat} are left out; stages that are added and removed while it runs are followed.
 *
 * <p>Add it to a pipeline or a player as a sink after the chain.
 *
 * <p>Thread rule: opened before the chain runs or on its thread, used as a handler on the
 * processing thread; the counts and {@link #close()} from any thread.
 *
 * @since 0.1
 */
public final class LiveResults implements StreamHandler, Closeable {
  private static final int ROOM = 16_384;
  private static final long TIMEOUT_MS = 2000;

  /** A result or a notification to send, or a number of lost ones. */
  private record Message(long number, String from, Object content) {}

  private static final Message END = new Message(0, "", 0L);

  private final FilterChain chain;
  private final LineOutput output;
  private final Predicate<String> wanted;
  private final LiveMessages messages;
  private final BlockingQueue<Message> waiting;
  private final Thread thread;
  private final List<Outlet.Subscription> subscriptions = new ArrayList<>();
  private List<ChainStage> followed = List.of();
  private long number;
  private volatile long unreported;
  private final AtomicLong lost = new AtomicLong();
  private volatile boolean closed;
  private volatile String failure;
  private volatile Consumer<String> onFailure = words -> {};

  /** Whether the waiting messages are the last ones, with no notification of loss after them. */
  private volatile boolean allPut;

  private LiveResults(
      FilterChain chain, LineOutput output, Predicate<String> wanted, Clock clock, int room) {
    this.chain = Objects.requireNonNull(chain, "chain");
    this.output = Objects.requireNonNull(output, "output");
    this.wanted = Objects.requireNonNull(wanted, "wanted");
    messages = new LiveMessages(clock);
    waiting = new ArrayBlockingQueue<>(room);
    thread = Daemon.thread(this::work, "haltere-publish");
    follow();
    thread.start();
  }

  /**
   * Starts publishing.
   *
   * @param chain of the filters
   * @param output receives the messages; closed with this
   * @param wanted chooses among the outlets by names such as {@code kalman-tracks/tracks}
   * @param clock for the time of sending
   * @return the running publication
   */
  public static LiveResults open(
      FilterChain chain, LineOutput output, Predicate<String> wanted, Clock clock) {
    return new LiveResults(chain, output, wanted, clock, ROOM);
  }

  /** As {@link #open}, with a maximum number of waiting messages. */
  static LiveResults open(FilterChain chain, LineOutput output, Clock clock, int room) {
    return new LiveResults(chain, output, name -> true, clock, room);
  }

  /**
   * The outlets of a chain that can be published.
   *
   * @param chain the chain, of which nested chains are part
   * @return names such as {@code kalman-tracks/tracks}, in the order of the chain
   */
  public static List<String> outlets(FilterChain chain) {
    List<String> names = new ArrayList<>();
    for (ChainStage stage : chain.innermostStages()) {
      for (Outlet<?> outlet : stage.filter().outlets()) {
        if (CsvSink.isFlat(outlet.type())) {
          names.add(stage.name() + "/" + outlet.name());
        }
      }
    }
    return names;
  }

  private void follow() {
    List<ChainStage> now = chain.innermostStages();
    if (!now.equals(followed)) {
      subscribe(now);
    }
  }

  private synchronized void subscribe(List<ChainStage> now) {
    unsubscribe();
    if (closed) {
      return;
    }
    followed = now;
    for (ChainStage stage : now) {
      for (Outlet<?> outlet : stage.filter().outlets()) {
        String from = stage.name() + "/" + outlet.name();
        if (CsvSink.isFlat(outlet.type()) && wanted.test(from)) {
          subscriptions.add(outlet.subscribe(result -> put(from, result)));
        }
      }
    }
  }

  private synchronized void unsubscribe() {
    subscriptions.forEach(Outlet.Subscription::close);
    subscriptions.clear();
  }

  // ---- The processing thread

  private void put(String from, Object content) {
    if (closed) {
      return;
    }
    number++;
    if (failure != null) {
      lost.incrementAndGet();
      return;
    }
    if (output.receivers() == 0) {
      return;
    }
    if (unreported > 0 && waiting.remainingCapacity() > 1) {
      waiting.add(new Message(0, "", unreported));
      unreported = 0;
    }
    if (unreported > 0 || !waiting.offer(new Message(number, from, content))) {
      unreported++;
      lost.incrementAndGet();
    }
  }

  @Override
  public void packet(EventPacket packet) {
    follow();
  }

  @Override
  public void notified(StreamNotification notification) {
    put("", notification);
  }

  // ---- The sending thread

  private void work() {
    try {
      Message next = waiting.take();
      while (next != END) {
        send(next);
        if (output.failure().isPresent()) {
          failed(output.failure().get());
          break;
        }
        next = allPut && waiting.isEmpty() ? END : waiting.take();
      }
    } catch (InterruptedException ignored) {
      // Waiting messages are counted as lost.
    } catch (RuntimeException | Error fault) {
      lost.incrementAndGet();
      failed("its sender failed: " + fault);
    } finally {
      lost.addAndGet(waiting.stream().filter(message -> message.number() > 0).count());
      output.close();
    }
  }

  private void failed(String words) {
    failure = words;
    onFailure.accept(words);
  }

  private void send(Message message) {
    if (message.content() instanceof Record row && !message.from().isEmpty()) {
      output.send(message.from(), messages.result(message.number(), message.from(), row));
    } else if (message.content() instanceof StreamNotification notification) {
      output.send("notification", messages.notification(message.number(), notification));
    } else {
      output.send("notification", messages.lost((Long) message.content(), "results came too fast"));
    }
  }

  /**
   * Where the messages can be received.
   *
   * @return as {@link LineOutput#address()}
   */
  public String address() {
    return output.address();
  }

  /**
   * Number of connected receivers.
   *
   * @return as {@link LineOutput#receivers()}
   */
  public int receivers() {
    return output.receivers();
  }

  /**
   * Messages that were dropped, here or for a receiver that was too slow, or after a {@link
   * #failure()}.
   *
   * @return a count
   */
  public long lost() {
    return lost.get() + output.lost();
  }

  /**
   * Number of refused receivers.
   *
   * @return as {@link LineOutput#refused()}
   */
  public long refused() {
    return output.refused();
  }

  /**
   * The reason why sending has stopped.
   *
   * @return a few words for users; empty while messages are sent
   */
  public Optional<String> failure() {
    return Optional.ofNullable(failure).or(output::failure);
  }

  /**
   * Sets a listener of the end of sending by a failure.
   *
   * @param listener receives a few words for users, on the sending thread
   */
  public void onFailure(Consumer<String> listener) {
    onFailure = listener;
  }

  /** Ends the subscriptions and sends waiting messages, for some seconds at most. */
  @Override
  public void close() {
    closed = true;
    unsubscribe();
    try {
      if (unreported > 0) {
        waiting.offer(new Message(0, "", unreported), TIMEOUT_MS, TimeUnit.MILLISECONDS);
      }
      allPut = true;
      waiting.offer(END);
      thread.join(TIMEOUT_MS);
    } catch (InterruptedException ignored) {
      Thread.currentThread().interrupt();
    }
    thread.interrupt();
  }
}
