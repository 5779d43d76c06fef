/* A chained hash table that grows, with deletion; counts of words. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct entry { char *key; int value; struct entry *next; } Entry;
typedef struct { Entry **buckets; unsigned size, count; } Table;

static unsigned hash(const char *s)
{
    unsigned h = 0;

    while (*s)
        h = h * 31 + (unsigned char) *s++;
    return h;
}

static void grow(Table *t)
{
    unsigned old = t->size, i;
    Entry **before = t->buckets;

    t->size = old ? old * 2 : 4;
    t->buckets = calloc(t->size, sizeof *t->buckets);
    for (i = 0; i < old; i++)
        while (before[i]) {
            Entry *e = before[i], **to = &t->buckets[hash(e->key) % t->size];
            before[i] = e->next;
            e->next = *to;
            *to = e;
        }
    free(before);
}

static int *lookup(Table *t, const char *key, int create)
{
    Entry *e;

    if (t->count >= t->size && create)
        grow(t);
    if (!t->size)
        return NULL;
    for (e = t->buckets[hash(key) % t->size]; e; e = e->next)
        if (!strcmp(e->key, key))
            return &e->value;
    if (!create)
        return NULL;
    e = malloc(sizeof *e);
    e->key = strcpy(malloc(strlen(key) + 1), key);
    e->value = 0;
    e->next = t->buckets[hash(key) % t->size];
    t->buckets[hash(key) % t->size] = e;
    t->count++;
    return &e->value;
}

static int delete(Table *t, const char *key)
{
    Entry **link;

    for (link = &t->buckets[hash(key) % t->size]; *link; link = &(*link)->next)
        if (!strcmp((*link)->key, key)) {
            Entry *gone = *link;
            *link = gone->next;
            free(gone->key);
            free(gone);
            t->count--;
            return 1;
        }
    return 0;
}

static int by_key(const void *a, const void *b)
{
    return strcmp((*(Entry *const *) a)->key, (*(Entry *const *) b)->key);
}

static void print_sorted(const Table *t)
{
    Entry *all[64], *e;
    unsigned i, n = 0;

    for (i = 0; i < t->size; i++)
        for (e = t->buckets[i]; e; e = e->next)
            all[n++] = e;
    qsort(all, n, sizeof *all, by_key);
    for (i = 0; i < n; i++)
        printf("%s=%d ", all[i]->key, all[i]->value);
    printf("(%u in %u)\n", t->count, t->size);
}

int main(void)
{
    Table t = { 0 };
    char text[] = "go left go right stop go back left stop sonar bump sonar go turn wait look";
    char key[12], *word;
    int i;

    for (word = strtok(text, " "); word; word = strtok(NULL, " "))
        ++*lookup(&t, word, 1);
    print_sorted(&t);
    printf("%d %d\n", delete(&t, "go"), delete(&t, "nothing"));
    print_sorted(&t);
    printf("%d\n", lookup(&t, "go", 0) == NULL);
    for (i = 0; i < 30; i++) {
        sprintf(key, "k%d", i * 7);
        *lookup(&t, key, 1) = i;
    }
    printf("%d %u %u\n", *lookup(&t, "k203", 0), t.count, t.size);
    return 0;
}
