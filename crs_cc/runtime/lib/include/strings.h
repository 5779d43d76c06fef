/* BSD string functions (POSIX strings.h). */
#ifndef _STRINGS_H
#define _STRINGS_H

#ifndef _SIZE_T
#define _SIZE_T
typedef unsigned int size_t;
#endif

int bcmp(const void *left, const void *right, size_t size);
void bcopy(const void *from, void *to, size_t size);
void bzero(void *bytes, size_t size);
int ffs(int value);
int ffsl(long value);
int ffsll(long long value);
char *index(const char *text, int c);
char *rindex(const char *text, int c);
int strcasecmp(const char *left, const char *right);
int strncasecmp(const char *left, const char *right, size_t size);

#endif
