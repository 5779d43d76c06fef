/* Searching and sorting (C17 7.22.5). */
#include <stdlib.h>

typedef int (*comparison)(const void *left, const void *right);

void *bsearch(const void *key, const void *items, size_t count, size_t size, comparison compare)
{
    const char *low = items;

    while (count > 0) {
        const char *middle = low + count / 2 * size;
        int order = compare(key, middle);
        if (order == 0)
            return (void *)middle;
        if (order > 0) {
            low = middle + size;
            count--;
        }
        count /= 2;
    }
    return NULL;
}

/* Merges two sorted neighbours, left first among equals. */
static void merge(char *left, char *middle, char *end, char *to, size_t size, comparison compare)
{
    char *right = middle;

    while (left < middle && right < end) {
        char **smaller = compare(left, right) <= 0 ? &left : &right;
        __builtin_memcpy(to, *smaller, size);
        *smaller += size;
        to += size;
    }
    __builtin_memcpy(to, left, middle - left);
    __builtin_memcpy(to + (middle - left), right, end - right);
}

/* Merge sort from the bottom up: stable, as programs learned to expect from Linux. */
static void merge_sort(char *items, char *room, size_t count, size_t size, comparison compare)
{
    char *from = items, *to = room, *swap;
    size_t total = count * size, width, start;

    for (width = size; width < total; width = width > total / 2 ? total : 2 * width) {
        for (start = 0; start < total; start += 2 * width) {
            size_t left = total - start;
            size_t middle = left < width ? left : width;
            size_t both = left - middle < width ? left : middle + width;
            merge(from + start, from + start + middle, from + start + both, to + start, size,
                  compare);
            if (both == left)
                break;
        }
        swap = from;
        from = to;
        to = swap;
    }
    if (from != items)
        __builtin_memcpy(items, from, total);
}

static void exchange(char *left, char *right, size_t size)
{
    while (size-- > 0) {
        char c = *left;
        *left++ = *right;
        *right++ = c;
    }
}

static void sift_down(char *items, size_t root, size_t count, size_t size, comparison compare)
{
    size_t child;

    while ((child = 2 * root + 1) < count) {
        if (child + 1 < count && compare(items + child * size, items + (child + 1) * size) < 0)
            child++;
        if (compare(items + root * size, items + child * size) >= 0)
            return;
        exchange(items + root * size, items + child * size, size);
        root = child;
    }
}

static void heap_sort(char *items, size_t count, size_t size, comparison compare)
{
    size_t i;

    for (i = count / 2; i-- > 0;)
        sift_down(items, i, count, size, compare);
    for (i = count; --i > 0;) {
        exchange(items, items + i * size, size);
        sift_down(items, 0, i, size, compare);
    }
}

/* Merge sort (Knuth, TAOCP 5.2.4); where memory is short, heap sort (5.2.3). Neither has a slow
   case and neither recurs. */
void qsort(void *items, size_t count, size_t size, comparison compare)
{
    char *room;

    if (count < 2 || size == 0)
        return;
    room = malloc(count * size);
    if (room == NULL) {
        heap_sort(items, count, size, compare);
        return;
    }
    merge_sort(items, room, count, size, compare);
    free(room);
}
