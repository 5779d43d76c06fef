/* POSIX search.h: linear search, lists, hash tables and trees. */
#ifndef _SEARCH_H
#define _SEARCH_H

#include <stddef.h>

void *lfind(const void *key, const void *items, size_t *count, size_t size,
            int (*compare)(const void *key, const void *item));
void *lsearch(const void *key, void *items, size_t *count, size_t size,
              int (*compare)(const void *key, const void *item));
typedef struct { char *key; void *data; } ENTRY;
typedef enum { FIND, ENTER } ACTION;
typedef enum { preorder, postorder, endorder, leaf } VISIT;

struct hsearch_data {
    ENTRY *__items;
    unsigned int __size, __count, __most;
};

int hcreate(size_t count);
void hdestroy(void);
ENTRY *hsearch(ENTRY item, ACTION action);
int hcreate_r(size_t count, struct hsearch_data *table);
void hdestroy_r(struct hsearch_data *table);
int hsearch_r(ENTRY item, ACTION action, ENTRY **found, struct hsearch_data *table);

void *tsearch(const void *key, void **root, int (*compare)(const void *, const void *));
void *tfind(const void *key, void *const *root, int (*compare)(const void *, const void *));
void *tdelete(const void *key, void **root, int (*compare)(const void *, const void *));
void twalk(const void *root, void (*act)(const void *node, VISIT which, int depth));
void tdestroy(void *root, void (*release)(void *key));

void insque(void *element, void *before);
void remque(void *element);

#endif
