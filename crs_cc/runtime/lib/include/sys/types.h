/* POSIX sys/types.h, with the short names of BSD. */
#ifndef _SYS_TYPES_H
#define _SYS_TYPES_H

#include <stdint.h>
#include <sys/cdefs.h>

#ifndef _SIZE_T
#define _SIZE_T
typedef unsigned int size_t;
#endif
#ifndef _SSIZE_T
#define _SSIZE_T
typedef int ssize_t;
#endif
#ifndef _TIME_T
#define _TIME_T
typedef long time_t;
#endif
#ifndef _CLOCK_T
#define _CLOCK_T
typedef long clock_t;
#endif
#ifndef _OFF_T
#define _OFF_T
typedef long off_t;
#endif
#ifndef _PID_T
#define _PID_T
typedef int pid_t;
#endif

typedef unsigned int uid_t;
typedef unsigned int gid_t;
typedef unsigned int mode_t;
typedef unsigned long ino_t;
typedef unsigned long dev_t;
typedef unsigned int nlink_t;
typedef unsigned int id_t;
typedef int key_t;
typedef long blksize_t;
typedef long blkcnt_t;
typedef long long quad_t;
typedef unsigned long long u_quad_t;
typedef long daddr_t;
typedef unsigned int useconds_t;
typedef long suseconds_t;
typedef char *caddr_t;

typedef uint8_t u_int8_t;
typedef uint16_t u_int16_t;
typedef uint32_t u_int32_t;
typedef uint64_t u_int64_t;
typedef unsigned char u_char;
typedef unsigned short u_short;
typedef unsigned int u_int;
typedef unsigned long u_long;
typedef unsigned short ushort;
typedef unsigned int uint;
typedef unsigned long ulong;

#endif
