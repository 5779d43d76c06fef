/* POSIX search.h: linear search and lists. */
#ifndef _SEARCH_H
#define _SEARCH_H

#include <stddef.h>

void *lfind(const void *key, const void *items, size_t *count, size_t size,
            int (*compare)(const void *key, const void *item));
void *lsearch(const void *key, void *items, size_t *count, size_t size,
              int (*compare)(const void *key, const void *item));
void insque(void *element, void *before);
void remque(void *element);

#endif
