/*
 * Faults of a disk and of a clock, for a program that is loaded with LD_PRELOAD: the C library's calls that reach files
 * below one folder fail as a kernel lets them fail. Numbers come from the environment; what is not named does not fail.
 *
 *   FAULTS_FOLDER         files below this path are concerned
 *   FAULTS_FULL_AFTER     bytes that fit on the disk; a write beyond them is short, the next one says ENOSPC
 *   FAULTS_LARGE_AFTER    length beyond which a file cannot grow: EFBIG
 *   FAULTS_READ_ERROR_AT  offset in a file from which reading says EIO
 *   FAULTS_SYNC_ERROR     1: forcing a file to the disk says EIO
 *   FAULTS_RENAME_ERROR   1: renaming says EIO
 *   FAULTS_LIST_ERROR     1: listing a folder says EIO
 *   FAULTS_SLOW_US        pause before each read and write
 *   FAULTS_CLOCK_JUMP_S   the time of day jumps by this at each hundredth question, forth and back
 */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>

static const char *folder;
static long full_after = -1, large_after = -1, read_error_at = -1, slow_us = -1, clock_jump_s = 0;
static int sync_error, rename_error, list_error;
static atomic_long written;
static atomic_long questions;

static long number(const char *name, long otherwise) {
  const char *text = getenv(name);
  return text == NULL ? otherwise : atol(text);
}

__attribute__((constructor)) static void start(void) {
  folder = getenv("FAULTS_FOLDER");
  full_after = number("FAULTS_FULL_AFTER", -1);
  large_after = number("FAULTS_LARGE_AFTER", -1);
  read_error_at = number("FAULTS_READ_ERROR_AT", -1);
  slow_us = number("FAULTS_SLOW_US", -1);
  clock_jump_s = number("FAULTS_CLOCK_JUMP_S", 0);
  sync_error = number("FAULTS_SYNC_ERROR", 0) != 0;
  rename_error = number("FAULTS_RENAME_ERROR", 0) != 0;
  list_error = number("FAULTS_LIST_ERROR", 0) != 0;
}

static int below(const char *path) { return folder != NULL && strncmp(path, folder, strlen(folder)) == 0; }

static int concerns(int fd) {
  if (folder == NULL) {
    return 0;
  }
  char link[64], path[PATH_MAX];
  snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) {
    return 0;
  }
  path[length] = 0;
  if (!below(path)) {
    return 0;
  }
  if (slow_us > 0) {
    struct timespec pause = {slow_us / 1000000, slow_us % 1000000 * 1000};
    nanosleep(&pause, NULL);
  }
  return 1;
}

/* The bytes of a write that fit, or -1 with errno where none does. */
static ssize_t fits(int fd, size_t bytes, off_t offset) {
  if (bytes == 0 || !concerns(fd)) {
    return (ssize_t)bytes;
  }
  if (large_after >= 0) {
    off_t at = offset >= 0 ? offset : lseek(fd, 0, SEEK_CUR);
    if (at >= large_after) {
      errno = EFBIG;
      return -1;
    }
    if ((off_t)bytes > large_after - at) {
      bytes = (size_t)(large_after - at);
    }
  }
  if (full_after >= 0) {
    long before = atomic_fetch_add(&written, (long)bytes);
    if (before >= full_after) {
      errno = ENOSPC;
      return -1;
    }
    if (before + (long)bytes > full_after) {
      bytes = (size_t)(full_after - before);
    }
  }
  return (ssize_t)bytes;
}

/* The bytes of a read that come before the bad one, or -1 with errno where none does. */
static ssize_t readable(int fd, size_t bytes, off_t offset) {
  if (!concerns(fd) || read_error_at < 0) {
    return (ssize_t)bytes;
  }
  off_t at = offset >= 0 ? offset : lseek(fd, 0, SEEK_CUR);
  if (at < 0 || at + (off_t)bytes <= read_error_at) {
    return (ssize_t)bytes;
  }
  if (at >= read_error_at) {
    errno = EIO;
    return -1;
  }
  return (ssize_t)(read_error_at - at);
}

ssize_t write(int fd, const void *from, size_t bytes) {
  ssize_t now = fits(fd, bytes, -1);
  return now < 0 ? -1 : syscall(SYS_write, fd, from, (size_t)now);
}

ssize_t pwrite64(int fd, const void *from, size_t bytes, off64_t offset) {
  ssize_t now = fits(fd, bytes, offset);
  return now < 0 ? -1 : syscall(SYS_pwrite64, fd, from, (size_t)now, offset);
}

ssize_t pwrite(int fd, const void *from, size_t bytes, off_t offset) { return pwrite64(fd, from, bytes, offset); }

ssize_t writev(int fd, const struct iovec *parts, int count) {
  for (int i = 0; i < count; i++) {
    if (parts[i].iov_len > 0) {
      return write(fd, parts[i].iov_base, parts[i].iov_len);
    }
  }
  return 0;
}

ssize_t read(int fd, void *to, size_t bytes) {
  ssize_t now = readable(fd, bytes, -1);
  return now < 0 ? -1 : syscall(SYS_read, fd, to, (size_t)now);
}

ssize_t pread64(int fd, void *to, size_t bytes, off64_t offset) {
  ssize_t now = readable(fd, bytes, offset);
  return now < 0 ? -1 : syscall(SYS_pread64, fd, to, (size_t)now, offset);
}

ssize_t pread(int fd, void *to, size_t bytes, off_t offset) { return pread64(fd, to, bytes, offset); }

ssize_t readv(int fd, const struct iovec *parts, int count) {
  for (int i = 0; i < count; i++) {
    if (parts[i].iov_len > 0) {
      return read(fd, parts[i].iov_base, parts[i].iov_len);
    }
  }
  return 0;
}

static int synced(int fd, long call) {
  if (sync_error && concerns(fd)) {
    errno = EIO;
    return -1;
  }
  return (int)syscall(call, fd);
}

int fsync(int fd) { return synced(fd, SYS_fsync); }

int fdatasync(int fd) { return synced(fd, SYS_fdatasync); }

int rename(const char *from, const char *to) {
  if (rename_error && below(to)) {
    errno = EIO;
    return -1;
  }
  int (*real)(const char *, const char *) = (int (*)(const char *, const char *))dlsym(RTLD_NEXT, "rename");
  return real(from, to);
}

struct dirent *readdir(DIR *listed) {
  if (list_error && concerns(dirfd(listed))) {
    errno = EIO;
    return NULL;
  }
  struct dirent *(*real)(DIR *) = (struct dirent *(*)(DIR *))dlsym(RTLD_NEXT, "readdir");
  return real(listed);
}

int clock_gettime(clockid_t clock, struct timespec *time) {
  static int (*real)(clockid_t, struct timespec *);
  if (real == NULL) {
    real = (int (*)(clockid_t, struct timespec *))dlsym(RTLD_NEXT, "clock_gettime");
  }
  int answer = real(clock, time);
  if (clock == CLOCK_REALTIME && clock_jump_s != 0 && atomic_fetch_add(&questions, 1) / 100 % 2 == 1) {
    time->tv_sec += clock_jump_s;
  }
  return answer;
}
