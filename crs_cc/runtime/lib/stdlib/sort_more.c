/* Sorting with an argument for the comparison (GNU qsort_r), and tables that are searched from
   their beginning (POSIX search.h). */
#include <search.h>
#include <stdlib.h>

static int (*compare_with)(const void *left, const void *right, void *extra);
static void *extra_argument;

static int compare_two(const void *left, const void *right)
{
    return compare_with(left, right, extra_argument);
}

/* A comparison may sort, too: the variables that it sets are restored. */
void qsort_r(void *items, size_t count, size_t size,
             int (*compare)(const void *left, const void *right, void *extra), void *extra)
{
    int (*outer)(const void *, const void *, void *) = compare_with;
    void *outer_argument = extra_argument;

    compare_with = compare;
    extra_argument = extra;
    qsort(items, count, size, compare_two);
    compare_with = outer;
    extra_argument = outer_argument;
}

static void *find(const void *key, const void *items, size_t count, size_t size,
                  int (*compare)(const void *key, const void *item))
{
    const char *item = items;

    for (; count > 0; count--, item += size)
        if (compare(key, item) == 0)
            return (void *)item;
    return NULL;
}

void *lfind(const void *key, const void *items, size_t *count, size_t size,
            int (*compare)(const void *key, const void *item))
{
    return find(key, items, *count, size, compare);
}

/* Appends the key when no item is equal to it. */
void *lsearch(const void *key, void *items, size_t *count, size_t size,
              int (*compare)(const void *key, const void *item))
{
    void *found = find(key, items, *count, size, compare);

    if (found == NULL) {
        found = (char *)items + *count * size;
        __builtin_memcpy(found, key, size);
        ++*count;
    }
    return found;
}

struct element {
    struct element *next, *previous;
};

/* Puts an element of a doubly linked list after another; a null pointer begins a list. */
void insque(void *element, void *before)
{
    struct element *new = element, *old = before;

    if (old == NULL) {
        new->next = new->previous = NULL;
        return;
    }
    new->next = old->next;
    new->previous = old;
    if (old->next != NULL)
        old->next->previous = new;
    old->next = new;
}

void remque(void *element)
{
    struct element *old = element;

    if (old->next != NULL)
        old->next->previous = old->previous;
    if (old->previous != NULL)
        old->previous->next = old->next;
}
