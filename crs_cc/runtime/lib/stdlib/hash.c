/* Hash tables (POSIX hsearch): open addressing in an array that is never full. */
#include <errno.h>
#include <search.h>
#include <stdlib.h>
#include <string.h>

static struct hsearch_data common;

static int create(size_t count, struct hsearch_data *table)
{
    if (table == NULL || table->__items != NULL || count > 0x1000000) {
        errno = table == NULL ? EINVAL : ENOMEM;
        return 0;
    }
    table->__size = count + count / 2 + 3;
    table->__most = count > 0 ? count : 1;
    table->__count = 0;
    table->__items = calloc(table->__size, sizeof *table->__items);
    return table->__items != NULL;
}

static void destroy(struct hsearch_data *table)
{
    free(table->__items);
    table->__items = NULL;
}

/* FNV-1a: http://www.isthe.com/chongo/tech/comp/fnv */
static unsigned int hash(const char *key)
{
    unsigned int value = 2166136261u;

    while (*key)
        value = (value ^ (unsigned char)*key++) * 16777619u;
    return value;
}

static int look_up(ENTRY item, ACTION action, ENTRY **found, struct hsearch_data *table)
{
    unsigned int at;

    *found = NULL;
    if (table->__items == NULL) {
        errno = EINVAL;
        return 0;
    }
    for (at = hash(item.key) % table->__size; table->__items[at].key != NULL;
         at = (at + 1) % table->__size)
        if (strcmp(table->__items[at].key, item.key) == 0) {
            *found = &table->__items[at];
            return 1;
        }
    if (action == FIND) {
        errno = ESRCH;
        return 0;
    }
    if (table->__count == table->__most) {
        errno = ENOMEM;
        return 0;
    }
    table->__count++;
    table->__items[at] = item;
    *found = &table->__items[at];
    return 1;
}

int hcreate_r(size_t count, struct hsearch_data *table)
{
    return create(count, table);
}

void hdestroy_r(struct hsearch_data *table)
{
    destroy(table);
}

int hsearch_r(ENTRY item, ACTION action, ENTRY **found, struct hsearch_data *table)
{
    return look_up(item, action, found, table);
}

int hcreate(size_t count)
{
    return create(count, &common);
}

void hdestroy(void)
{
    destroy(&common);
}

ENTRY *hsearch(ENTRY item, ACTION action)
{
    ENTRY *found;

    look_up(item, action, &found, &common);
    return found;
}
