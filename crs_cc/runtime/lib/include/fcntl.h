/* POSIX fcntl.h: opening files, with the constants of Linux. */
#ifndef _FCNTL_H
#define _FCNTL_H

#include <sys/types.h>

#define O_ACCMODE 03
#define O_RDONLY 00
#define O_WRONLY 01
#define O_RDWR 02
#define O_CREAT 0100
#define O_EXCL 0200
#define O_NOCTTY 0400
#define O_TRUNC 01000
#define O_APPEND 02000
#define O_NONBLOCK 04000
#define O_NDELAY O_NONBLOCK
#define FASYNC 020000
#define O_ASYNC FASYNC
#define O_SYNC 04010000
#define O_BINARY 0
#define O_TEXT 0
#define O_CLOEXEC 02000000
#define O_TMPFILE 020000000

#define F_DUPFD 0
#define F_GETFD 1
#define F_SETFD 2
#define F_GETFL 3
#define F_SETFL 4
#define F_SETOWN 8
#define F_GETOWN 9
#define FD_CLOEXEC 1

int open(const char *name, int flags, ...);
int creat(const char *name, mode_t mode);
int fcntl(int descriptor, int command, ...);

#endif
