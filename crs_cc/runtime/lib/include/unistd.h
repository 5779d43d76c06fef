/* POSIX unistd.h: the supported part; other functions fail with an error. */
#ifndef _UNISTD_H
#define _UNISTD_H

#include <getopt.h>
#include <stddef.h>
#include <sys/types.h>

#define STDIN_FILENO 0
#define STDOUT_FILENO 1
#define STDERR_FILENO 2

#ifndef SEEK_SET
#define SEEK_SET 0
#define SEEK_CUR 1
#define SEEK_END 2
#endif
#define L_SET SEEK_SET
#define L_INCR SEEK_CUR
#define L_XTND SEEK_END

#define F_OK 0
#define X_OK 1
#define W_OK 2
#define R_OK 4

#define _SC_CLK_TCK 2
#define _SC_OPEN_MAX 4
#define _SC_PAGESIZE 30
#define _SC_PAGE_SIZE _SC_PAGESIZE
#define _SC_NPROCESSORS_CONF 83
#define _SC_NPROCESSORS_ONLN 84

/* Descriptors and files. */
ssize_t read(int descriptor, void *bytes, size_t size);
ssize_t write(int descriptor, const void *bytes, size_t size);
ssize_t pread(int descriptor, void *bytes, size_t size, off_t offset);
ssize_t pwrite(int descriptor, const void *bytes, size_t size, off_t offset);
int close(int descriptor);
off_t lseek(int descriptor, off_t offset, int whence);
int ftruncate(int descriptor, off_t size);
int truncate(const char *name, off_t size);
int dup(int descriptor);
int dup2(int descriptor, int wanted);
int fsync(int descriptor);
int fdatasync(int descriptor);
void sync(void);
int isatty(int descriptor);
char *ttyname(int descriptor);
int access(const char *name, int mode);
int unlink(const char *name);
int rmdir(const char *name);
int link(const char *from, const char *to);
int symlink(const char *from, const char *to);
ssize_t readlink(const char *name, char *text, size_t size);
int chdir(const char *name);
char *getcwd(char *text, size_t size);
int chown(const char *name, uid_t owner, gid_t group);
int pipe(int descriptors[2]);
int getpagesize(void);
void *sbrk(int increment);
int brk(void *end);
int getdtablesize(void);
long sysconf(int name);

/* Time and signals. */
unsigned int sleep(unsigned int seconds);
int usleep(useconds_t microseconds);
unsigned int alarm(unsigned int seconds);
unsigned int ualarm(unsigned int first, unsigned int interval);
int pause(void);

/* User and process: a program is the only one on its machine. */
pid_t getpid(void);
pid_t getppid(void);
pid_t getpgrp(void);
pid_t setsid(void);
uid_t getuid(void);
uid_t geteuid(void);
gid_t getgid(void);
gid_t getegid(void);
int setuid(uid_t user);
int setgid(gid_t group);
int seteuid(uid_t user);
int setegid(gid_t group);
int setreuid(uid_t user, uid_t effective);
int setregid(gid_t group, gid_t effective);
int setresuid(uid_t user, uid_t effective, uid_t saved);
int setresgid(gid_t group, gid_t effective, gid_t saved);
int gethostname(char *name, size_t size);
char *getlogin(void);
int nice(int increment);

/* Processes. */
pid_t fork(void);
pid_t vfork(void);
int execl(const char *file, const char *argument, ...);
int execlp(const char *file, const char *argument, ...);
int execle(const char *file, const char *argument, ...);
int execv(const char *file, char *const arguments[]);
int execvp(const char *file, char *const arguments[]);
int execve(const char *file, char *const arguments[], char *const environment[]);
_Noreturn void _exit(int status);

extern char **environ;

void swab(const void *from, void *to, ssize_t size);

#endif
