/*
 * usbemu: a user-space stand-in for Linux usbfs, as an LD_PRELOAD library.
 *
 * It lets an unmodified libusb (the one inside usb4java's libusb4java.so) find,
 * open and use USB devices that exist only in a test program. No kernel support,
 * no root and no package besides a C compiler are needed.
 *
 *   path names     /sys/bus, /sys/devices/usbemu, /dev/bus/usb and /run/udev are
 *                  looked up below $USBEMU_DIR instead (the test writes that tree).
 *   usbfs node     open() connects to the UNIX stream socket $USBEMU_DIR/BBB-DDD.sock.
 *                  URBs and the simple ioctls become messages on it.
 *                  The descriptor that libusb gets is the write end of a pipe that is
 *                  kept full: poll() says POLLOUT exactly while an URB can be reaped,
 *                  and POLLERR once the device is gone, as usbfs does.
 *   udev monitor   socket(AF_NETLINK, NETLINK_KOBJECT_UEVENT) becomes a connection to
 *                  $USBEMU_DIR/uevent.sock; each message is a 4-byte length and a
 *                  kernel-style uevent ("add@/devices/...\0KEY=VALUE\0...").
 *   stamps         if $USBEMU_DIR/stamps is there (65537 words of 64 bits), word 0 counts the
 *                  bulk transfers that came with data, and word 1 + n % 65536 is the time at
 *                  which the n-th was handed over, nanoseconds of CLOCK_MONOTONIC. Before that the
 *                  thread of the camera's firmware may end what it does, on whose processor this one
 *                  mostly runs: a camera has a processor of its own.
 *   forbidden      a node whose $USBEMU_DIR/BBB-DDD.forbidden is there gives EACCES.
 *
 * Build: cc -O2 -Wall -Wextra -shared -fPIC -o libusbemu.so usbemu.c -ldl -lpthread
 * Use:   LD_PRELOAD=/abs/libusbemu.so USBEMU_DIR=/tmp/x java ...
 * Without USBEMU_DIR every call passes straight through.
 */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <linux/netlink.h>
#include <linux/usbdevice_fs.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

#define REAL(name) static __typeof__(name) *real_; \
    if (!real_) real_ = (__typeof__(name) *) dlsym(RTLD_NEXT, #name)

/* ---- wire format (host byte order, both ends are on one machine) ---- */
enum { M_SUBMIT = 1, M_DISCARD = 2, M_CALL = 3, M_GONE = 4 };
struct msg {            /* 40 bytes, then len bytes of payload          */
    uint32_t type, len;
    uint64_t id;        /* URB id or call number                        */
    int64_t a, b, c;    /* SUBMIT a=urb type b=endpoint c=buffer length */
};                      /* answers: a=status (-errno) b=actual length   */

/* ---- one open usbfs node ---- */
struct pend { struct usbdevfs_urb *urb; uint64_t id; struct pend *next; };
struct handle {
    int sock, pipe_r, pipe_w;       /* pipe_w is what libusb holds */
    int gone, raised, closing;
    pthread_mutex_t lock, send_lock, call_lock;
    pthread_cond_t cond;
    pthread_t reader;
    struct pend *pending, *done_head, **done_tail;
    uint64_t next_id, call_id;
    int call_done; int64_t call_a, call_b;
};

#define MAXFD 65536
static struct handle *handles[MAXFD];
static unsigned char uevent_fd[MAXFD];
static pthread_mutex_t table_lock = PTHREAD_MUTEX_INITIALIZER;

static const char *base(void) { static const char *b; if (!b) { b = getenv("USBEMU_DIR"); if (!b) b = ""; } return *b ? b : NULL; }
static struct handle *handle_of(int fd) { return fd >= 0 && fd < MAXFD ? __atomic_load_n(&handles[fd], __ATOMIC_ACQUIRE) : NULL; }

static int under(const char *p, const char *prefix) {
    size_t n = strlen(prefix);
    return !strncmp(p, prefix, n) && (p[n] == 0 || p[n] == '/');
}
static const char *map(const char *p, char *buf) {
    const char *b = base();
    if (!b || !p || p[0] != '/') return p;
    if (!under(p, "/sys/bus") && !under(p, "/sys/devices/usbemu") && !under(p, "/dev/bus/usb") && !under(p, "/run/udev")) return p;
    if ((size_t) snprintf(buf, PATH_MAX, "%s%s", b, p) >= PATH_MAX) return p;
    return buf;
}

static void close_real(int fd) { REAL(close); real_(fd); }
static int connect_to(const char *name) {
    struct sockaddr_un sa = { .sun_family = AF_UNIX };
    if ((size_t) snprintf(sa.sun_path, sizeof sa.sun_path, "%s/%s", base(), name) >= sizeof sa.sun_path) { errno = ENAMETOOLONG; return -1; }
    REAL(socket);
    int s = real_(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (s < 0) return -1;
    if (connect(s, (struct sockaddr *) &sa, sizeof sa)) { int e = errno; REAL(close); real_(s); errno = e; return -1; }
    return s;
}
static int read_all(int fd, void *p, size_t n) {
    char *c = p;
    while (n) { ssize_t r = recv(fd, c, n, 0); if (r < 0 && errno == EINTR) continue; if (r <= 0) return -1; c += r; n -= (size_t) r; }
    return 0;
}
static int write_all(int fd, const void *p, size_t n) {
    const char *c = p;
    while (n) { ssize_t r = send(fd, c, n, MSG_NOSIGNAL); if (r < 0 && errno == EINTR) continue; if (r <= 0) return -1; c += r; n -= (size_t) r; }
    return 0;
}
/* Lock order: call_lock, send_lock, lock. send_lock keeps messages whole and in URB order; lock is
   never held while sending, or a slow emulator could block the reader thread for good. */
static int send_msg(struct handle *h, struct msg m, const void *payload) {   /* caller holds send_lock */
    int r = write_all(h->sock, &m, sizeof m);
    return !r && m.len ? write_all(h->sock, payload, m.len) : r;
}

/* pipe full = nothing to reap; pipe empty = POLLOUT. Callers hold h->lock. */
static char page[4096];
static void lower(struct handle *h) { if (h->raised) { while (write(h->pipe_w, page, sizeof page) > 0) ; h->raised = 0; } }
static void raise_(struct handle *h) { if (!h->raised) { char b[4096]; while (read(h->pipe_r, b, sizeof b) > 0) ; h->raised = 1; } }

#define STAMPS 65536
static uint64_t *stamps;
static void map_stamps(void) {                 /* by the first open of a node, before its reader runs */
    char name[PATH_MAX];
    REAL(open);
    snprintf(name, sizeof name, "%s/stamps", base());
    int fd = stamps ? -1 : real_(name, O_RDWR | O_CLOEXEC);
    if (fd < 0) return;
    void *m = mmap(NULL, (STAMPS + 1) * sizeof *stamps, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    if (m != MAP_FAILED) stamps = m;
    close_real(fd);
}
static void stamp(void) {                      /* callers hold the lock of the only device that streams */
    struct timespec now;
    if (!stamps || clock_gettime(CLOCK_MONOTONIC, &now)) return;
    stamps[1 + stamps[0] % STAMPS] = (uint64_t) now.tv_sec * 1000000000u + (uint64_t) now.tv_nsec;
    __atomic_store_n(stamps, stamps[0] + 1, __ATOMIC_RELEASE);
}
static void push_done(struct handle *h, struct pend *p, int status, int actual) {
    p->urb->status = status; p->urb->actual_length = actual; p->next = NULL;
    *h->done_tail = p; h->done_tail = &p->next;
    raise_(h);
}
static struct pend *take_pending(struct handle *h, uint64_t id, void *urb) {
    for (struct pend **q = &h->pending; *q; q = &(*q)->next)
        if (urb ? (*q)->urb == urb : (*q)->id == id) { struct pend *p = *q; *q = p->next; return p; }
    return NULL;
}

static void *reader_main(void *arg) {
    struct handle *h = arg;
    struct msg m;
    while (!read_all(h->sock, &m, sizeof m)) {
        char *data = m.len ? malloc(m.len) : NULL;
        if (m.len && (!data || read_all(h->sock, data, m.len))) { free(data); break; }
        if (m.type == M_GONE) { free(data); break; }
        if (stamps) sched_yield();      /* see above */
        pthread_mutex_lock(&h->lock);
        if (m.type == M_CALL && m.id == h->call_id) { h->call_a = m.a; h->call_b = m.b; h->call_done = 1; pthread_cond_broadcast(&h->cond); }
        if (m.type == M_SUBMIT) {
            struct pend *p = take_pending(h, m.id, NULL);      /* NULL: discarded meanwhile */
            if (p) {
                int off = p->urb->type == USBDEVFS_URB_TYPE_CONTROL ? 8 : 0;
                int room = p->urb->buffer_length - off;
                if ((int) m.len > room) m.len = (uint32_t) (room < 0 ? 0 : room);
                if (m.len) memcpy((char *) p->urb->buffer + off, data, m.len);
                if (p->urb->type == USBDEVFS_URB_TYPE_BULK && m.len && !m.a) stamp();
                push_done(h, p, (int) m.a, (int) m.b);
            }
        }
        pthread_mutex_unlock(&h->lock);
        free(data);
    }
    pthread_mutex_lock(&h->lock);                              /* unplugged */
    h->gone = 1;
    while (h->pending) { struct pend *p = h->pending; h->pending = p->next; push_done(h, p, -ESHUTDOWN, 0); }
    pthread_cond_broadcast(&h->cond);
    if (h->pipe_r >= 0) { close(h->pipe_r); h->pipe_r = -1; h->raised = 1; }   /* POLLERR from now on */
    pthread_mutex_unlock(&h->lock);
    return NULL;
}

static int64_t call(struct handle *h, int64_t nr, int64_t arg, int64_t *val) {
    pthread_mutex_lock(&h->call_lock);                          /* one call at a time */
    pthread_mutex_lock(&h->lock);
    struct msg m = { .type = M_CALL, .id = ++h->call_id, .a = nr, .b = arg };
    h->call_done = 0;
    pthread_mutex_unlock(&h->lock);
    pthread_mutex_lock(&h->send_lock);
    int bad = send_msg(h, m, NULL);
    pthread_mutex_unlock(&h->send_lock);
    pthread_mutex_lock(&h->lock);
    while (!bad && !h->call_done && !h->gone) pthread_cond_wait(&h->cond, &h->lock);
    int64_t r = h->call_done ? h->call_a : -ENODEV;
    if (val) *val = h->call_b;
    pthread_mutex_unlock(&h->lock);
    pthread_mutex_unlock(&h->call_lock);
    return r;
}

static int open_node(const char *path, int flags) {
    int bus, dev; char name[32], tail;
    if (!base() || !path || sscanf(path, "/dev/bus/usb/%d/%d%c", &bus, &dev, &tail) != 2) return -2;
    if ((flags & O_ACCMODE) == O_RDONLY) return -2;            /* descriptors only: plain file */
    char forbidden[PATH_MAX];
    snprintf(forbidden, sizeof forbidden, "%s/%03d-%03d.forbidden", base(), bus, dev);
    REAL(access);
    if (!real_(forbidden, F_OK)) { errno = EACCES; return -1; }   /* as for a user without the right */
    snprintf(name, sizeof name, "%03d-%03d.sock", bus, dev);
    map_stamps();
    struct handle *h = calloc(1, sizeof *h);
    int p[2];
    if ((h->sock = connect_to(name)) < 0) { free(h); errno = errno == EACCES ? EACCES : ENODEV; return -1; }
    if (pipe2(p, O_CLOEXEC | O_NONBLOCK)) { close(h->sock); free(h); return -1; }
    fcntl(p[1], F_SETPIPE_SZ, 4096);
    h->pipe_r = p[0]; h->pipe_w = p[1]; h->raised = 1; h->done_tail = &h->done_head;
    pthread_mutex_init(&h->lock, NULL); pthread_mutex_init(&h->send_lock, NULL); pthread_mutex_init(&h->call_lock, NULL);
    pthread_cond_init(&h->cond, NULL);
    lower(h);
    if (h->pipe_w >= MAXFD || pthread_create(&h->reader, NULL, reader_main, h)) { close(h->sock); close(p[0]); close(p[1]); free(h); errno = EMFILE; return -1; }
    __atomic_store_n(&handles[h->pipe_w], h, __ATOMIC_RELEASE);
    return h->pipe_w;
}

static int usbfs_ioctl(struct handle *h, unsigned long req, void *arg) {
    int64_t r, val = 0;
    switch (req) {
    case USBDEVFS_GET_CAPABILITIES:
        *(uint32_t *) arg = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_BULK_SCATTER_GATHER | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
        return 0;
    case USBDEVFS_SUBMITURB: {
        struct usbdevfs_urb *u = arg;
        int ctl = u->type == USBDEVFS_URB_TYPE_CONTROL, in = ctl ? *(uint8_t *) u->buffer & 0x80 : u->endpoint & 0x80;
        struct msg m = { .type = M_SUBMIT, .a = u->type, .b = u->endpoint, .c = u->buffer_length,
                         .len = ctl && in ? 8 : in ? 0 : (uint32_t) u->buffer_length };
        struct pend *p = malloc(sizeof *p), **q;
        pthread_mutex_lock(&h->send_lock);
        pthread_mutex_lock(&h->lock);
        if (h->gone) { pthread_mutex_unlock(&h->lock); pthread_mutex_unlock(&h->send_lock); free(p); errno = ENODEV; return -1; }
        p->urb = u; p->id = m.id = ++h->next_id; p->next = NULL;
        for (q = &h->pending; *q; q = &(*q)->next) ;
        *q = p;
        u->status = -EINPROGRESS; u->actual_length = 0;
        pthread_mutex_unlock(&h->lock);
        send_msg(h, m, u->buffer);                              /* if this fails the reader ends the URB */
        pthread_mutex_unlock(&h->send_lock);
        return 0; }
    case USBDEVFS_DISCARDURB: {
        struct msg m = { .type = M_DISCARD };
        pthread_mutex_lock(&h->send_lock);
        pthread_mutex_lock(&h->lock);
        struct pend *p = take_pending(h, 0, arg);
        int e = p ? 0 : h->gone ? ENODEV : EINVAL;
        if (p) { m.id = p->id; push_done(h, p, -ENOENT, 0); }
        pthread_mutex_unlock(&h->lock);
        if (!e) send_msg(h, m, NULL);
        pthread_mutex_unlock(&h->send_lock);
        if (e) { errno = e; return -1; }
        return 0; }
    case USBDEVFS_REAPURB: case USBDEVFS_REAPURBNDELAY: {
        pthread_mutex_lock(&h->lock);
        struct pend *p = h->done_head;
        if (!p) { int e = h->gone ? ENODEV : EAGAIN; pthread_mutex_unlock(&h->lock); errno = e; return -1; }
        h->done_head = p->next;
        if (!h->done_head) { h->done_tail = &h->done_head; if (!h->gone) lower(h); }
        pthread_mutex_unlock(&h->lock);
        *(void **) arg = p->urb;
        free(p);
        return 0; }
    case USBDEVFS_CLAIMINTERFACE: case USBDEVFS_RELEASEINTERFACE: case USBDEVFS_SETCONFIGURATION:
    case USBDEVFS_CLEAR_HALT: case USBDEVFS_RESETEP: r = call(h, (int64_t) (req & 0xff), *(unsigned *) arg, NULL); break;
    case USBDEVFS_SETINTERFACE: { struct usbdevfs_setinterface *s = arg; r = call(h, (int64_t) (req & 0xff), (int64_t) s->interface << 8 | s->altsetting, NULL); break; }
    case USBDEVFS_RESET: r = call(h, (int64_t) (req & 0xff), 0, NULL); break;
    case USBDEVFS_GETDRIVER: {
        struct usbdevfs_getdriver *g = arg;
        r = call(h, (int64_t) (req & 0xff), g->interface, &val);
        if (!r) snprintf(g->driver, sizeof g->driver, val ? "usbfs" : "emukernel");
        break; }
    case USBDEVFS_IOCTL: case USBDEVFS_DISCONNECT_CLAIM: r = call(h, (int64_t) (req & 0xff), 0, NULL); break;
    default: errno = ENOTTY; return -1;
    }
    if (r < 0) { errno = (int) -r; return -1; }
    return (int) r;
}

/* ---- interposed functions ---- */
int ioctl(int fd, unsigned long req, ...) {
    va_list ap; va_start(ap, req); void *arg = va_arg(ap, void *); va_end(ap);
    struct handle *h = handle_of(fd);
    if (h) return usbfs_ioctl(h, req, arg);
    REAL(ioctl);
    return real_(fd, req, arg);
}
int close(int fd) {
    REAL(close);
    if (fd >= 0 && fd < MAXFD) {
        uevent_fd[fd] = 0;
        pthread_mutex_lock(&table_lock);
        struct handle *h = handles[fd];
        __atomic_store_n(&handles[fd], NULL, __ATOMIC_RELEASE);
        pthread_mutex_unlock(&table_lock);
        if (h) {
            shutdown(h->sock, SHUT_RDWR);
            pthread_join(h->reader, NULL);
            real_(h->sock);
            while (h->done_head) { struct pend *p = h->done_head; h->done_head = p->next; free(p); }
            free(h);
        }
    }
    return real_(fd);
}

#define OPEN(name) int name(const char *path, int flags, ...) { \
    va_list ap; va_start(ap, flags); mode_t mode = va_arg(ap, mode_t); va_end(ap); \
    int fd = open_node(path, flags); if (fd != -2) return fd; \
    char b[PATH_MAX]; REAL(name); return real_(map(path, b), flags, mode); }
OPEN(open) OPEN(open64)
#define OPENAT(name) int name(int d, const char *path, int flags, ...) { \
    va_list ap; va_start(ap, flags); mode_t mode = va_arg(ap, mode_t); va_end(ap); \
    int fd = open_node(path, flags); if (fd != -2) return fd; \
    char b[PATH_MAX]; REAL(name); return real_(d, map(path, b), flags, mode); }
OPENAT(openat) OPENAT(openat64)

FILE *fopen(const char *p, const char *m) { char b[PATH_MAX]; REAL(fopen); return real_(map(p, b), m); }
FILE *fopen64(const char *p, const char *m) { char b[PATH_MAX]; REAL(fopen64); return real_(map(p, b), m); }
DIR *opendir(const char *p) { char b[PATH_MAX]; REAL(opendir); return real_(map(p, b)); }
int access(const char *p, int m) { char b[PATH_MAX]; REAL(access); return real_(map(p, b), m); }
ssize_t readlink(const char *p, char *o, size_t n) { char b[PATH_MAX]; REAL(readlink); return real_(map(p, b), o, n); }
#define STAT(name, type) int name(const char *p, struct type *s) { char b[PATH_MAX]; REAL(name); return real_(map(p, b), s); }
STAT(stat, stat) STAT(lstat, stat) STAT(stat64, stat64) STAT(lstat64, stat64)
int __xstat(int, const char *, struct stat *); int __lxstat(int, const char *, struct stat *);
int __xstat64(int, const char *, struct stat64 *); int __lxstat64(int, const char *, struct stat64 *);
#define XSTAT(name, type) int name(int v, const char *p, struct type *s) { char b[PATH_MAX]; REAL(name); return real_(v, map(p, b), s); }
XSTAT(__xstat, stat) XSTAT(__lxstat, stat) XSTAT(__xstat64, stat64) XSTAT(__lxstat64, stat64)
int fstatat(int d, const char *p, struct stat *s, int f) { char b[PATH_MAX]; REAL(fstatat); return real_(d, map(p, b), s, f); }

/* ---- the udev monitor's netlink socket ---- */
#define IS_UEVENT(fd) ((fd) >= 0 && (fd) < MAXFD && uevent_fd[fd])
int socket(int domain, int type, int proto) {
    REAL(socket);
    if (base() && domain == AF_NETLINK && proto == NETLINK_KOBJECT_UEVENT) {
        int s = connect_to("uevent.sock"), sv[2];
        if (s < 0 && !socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sv)) s = sv[0];   /* silent: no emulator yet */
        if (s >= 0 && s < MAXFD) { uevent_fd[s] = 1; if (type & SOCK_NONBLOCK) fcntl(s, F_SETFL, O_NONBLOCK); }
        return s;
    }
    return real_(domain, type, proto);
}
int bind(int fd, const struct sockaddr *sa, socklen_t n) { REAL(bind); return IS_UEVENT(fd) ? 0 : real_(fd, sa, n); }
int setsockopt(int fd, int l, int o, const void *v, socklen_t n) { REAL(setsockopt); return IS_UEVENT(fd) ? 0 : real_(fd, l, o, v, n); }
int getsockname(int fd, struct sockaddr *sa, socklen_t *n) {
    REAL(getsockname);
    if (!IS_UEVENT(fd)) return real_(fd, sa, n);
    struct sockaddr_nl nl = { .nl_family = AF_NETLINK, .nl_pid = (uint32_t) getpid() };
    memcpy(sa, &nl, *n < sizeof nl ? *n : sizeof nl); *n = sizeof nl;
    return 0;
}
ssize_t recvmsg(int fd, struct msghdr *m, int flags) {
    REAL(recvmsg);
    if (!IS_UEVENT(fd)) return real_(fd, m, flags);
    uint32_t len; char buf[8192];
    ssize_t r = recv(fd, &len, sizeof len, MSG_PEEK | MSG_DONTWAIT);
    if (r < (ssize_t) sizeof len) { errno = EAGAIN; if (r == 0) usleep(20000); return -1; }
    if (read_all(fd, &len, sizeof len) || len > sizeof buf || read_all(fd, buf, len)) { errno = EAGAIN; return -1; }
    size_t n = len < m->msg_iov[0].iov_len ? len : m->msg_iov[0].iov_len;
    memcpy(m->msg_iov[0].iov_base, buf, n);
    if (m->msg_name) { struct sockaddr_nl nl = { .nl_family = AF_NETLINK, .nl_groups = 1 }; memcpy(m->msg_name, &nl, sizeof nl); m->msg_namelen = sizeof nl; }
    if (m->msg_control && m->msg_controllen >= CMSG_SPACE(sizeof(struct ucred))) {     /* "sent by root" */
        struct cmsghdr *c = CMSG_FIRSTHDR(m); struct ucred cr = { .pid = 0, .uid = 0, .gid = 0 };
        c->cmsg_level = SOL_SOCKET; c->cmsg_type = SCM_CREDENTIALS; c->cmsg_len = CMSG_LEN(sizeof cr);
        memcpy(CMSG_DATA(c), &cr, sizeof cr); m->msg_controllen = CMSG_SPACE(sizeof cr);
    }
    m->msg_flags = 0;
    return (ssize_t) n;
}
