/* BSD sys/param.h: sizes, MIN and MAX. */
#ifndef _SYS_PARAM_H
#define _SYS_PARAM_H

#include <limits.h>
#include <sys/types.h>

#define MAXPATHLEN PATH_MAX
#define MAXHOSTNAMELEN 64
#define NBBY CHAR_BIT
#define NOFILE 64
#define HZ 100
#define MIN(left, right) ((left) < (right) ? (left) : (right))
#define MAX(left, right) ((left) > (right) ? (left) : (right))
#define howmany(value, unit) (((value) + (unit) - 1) / (unit))
#define roundup(value, unit) (howmany(value, unit) * (unit))
#define setbit(bits, i) ((bits)[(i) / NBBY] |= 1 << (i) % NBBY)
#define clrbit(bits, i) ((bits)[(i) / NBBY] &= ~(1 << (i) % NBBY))
#define isset(bits, i) ((bits)[(i) / NBBY] & 1 << (i) % NBBY)
#define isclr(bits, i) (!isset(bits, i))

#endif
