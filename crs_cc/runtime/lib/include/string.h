/* C17 7.24: strings, and Linux extensions. */
#ifndef _STRING_H
#define _STRING_H

#include <strings.h>
#include <sys/cdefs.h>

#ifndef NULL
#define NULL ((void *)0)
#endif

void *memcpy(void *to, const void *from, size_t size);
void *memmove(void *to, const void *from, size_t size);
void *memset(void *bytes, int value, size_t size);
int memcmp(const void *left, const void *right, size_t size);
void *memchr(const void *bytes, int c, size_t size);

char *strcpy(char *to, const char *from);
char *strncpy(char *to, const char *from, size_t size);
char *strcat(char *to, const char *from);
char *strncat(char *to, const char *from, size_t size);
int strcmp(const char *left, const char *right);
int strncmp(const char *left, const char *right, size_t size);
int strcoll(const char *left, const char *right);
size_t strxfrm(char *to, const char *from, size_t size);
char *strchr(const char *text, int c);
char *strrchr(const char *text, int c);
size_t strspn(const char *text, const char *accept);
size_t strcspn(const char *text, const char *reject);
char *strpbrk(const char *text, const char *accept);
char *strstr(const char *text, const char *part);
char *strtok(char *text, const char *separators);
size_t strlen(const char *text);
char *strerror(int number);

char *strdup(const char *text);
char *strndup(const char *text, size_t size);
size_t strnlen(const char *text, size_t size);
char *strtok_r(char *text, const char *separators, char **rest);
char *strsep(char **text, const char *separators);
char *stpcpy(char *to, const char *from);
char *stpncpy(char *to, const char *from, size_t size);
size_t strlcpy(char *to, const char *from, size_t size);
size_t strlcat(char *to, const char *from, size_t size);
char *strchrnul(const char *text, int c);
char *strcasestr(const char *text, const char *part);
char *strsignal(int signal);
char *strerror_r(int number, char *text, size_t size);
#ifndef basename
char *basename(const char *path);
#endif
void *memccpy(void *to, const void *from, int c, size_t size);
void *mempcpy(void *to, const void *from, size_t size);
void *memrchr(const void *bytes, int c, size_t size);
void *rawmemchr(const void *bytes, int c);
void *memmem(const void *bytes, size_t size, const void *part, size_t part_size);
void explicit_bzero(void *bytes, size_t size);

#define strdupa(text) strcpy(__builtin_alloca(strlen(text) + 1), text)

#endif
