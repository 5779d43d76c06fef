/* BSD sys/cdefs.h: declarations for old and new compilers. */
#ifndef _SYS_CDEFS_H
#define _SYS_CDEFS_H

#define __BEGIN_DECLS
#define __END_DECLS
#define __P(parameters) parameters
#define __PMT(parameters) parameters
#define __CONCAT(left, right) left##right
#define __STRING(text) #text
#define __THROW

#endif
