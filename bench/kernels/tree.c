/* A search tree from malloc: recursive insertion, search, depth, and removal of all of it. */
#include <stdio.h>
#include <stdlib.h>

struct tree {
    struct tree *left, *right;
    int key, count;
};

static struct tree *insert(struct tree *t, int key)
{
    if (t == NULL) {
        t = malloc(sizeof *t);
        t->left = t->right = NULL;
        t->key = key;
        t->count = 1;
    } else if (key < t->key)
        t->left = insert(t->left, key);
    else if (key > t->key)
        t->right = insert(t->right, key);
    else
        t->count++;
    return t;
}

static int depth(const struct tree *t)
{
    int left, right;

    if (t == NULL)
        return 0;
    left = depth(t->left);
    right = depth(t->right);
    return 1 + (left > right ? left : right);
}

static long sum(const struct tree *t)
{
    return t == NULL ? 0 : sum(t->left) + t->key % 7 * t->count + sum(t->right);
}

static void destroy(struct tree *t)
{
    if (t != NULL) {
        destroy(t->left);
        destroy(t->right);
        free(t);
    }
}

int main(void)
{
    unsigned seed = 11;
    long total = 0;
    int round, i;

    for (round = 0; round < 20; round++) {
        struct tree *t = NULL;
        for (i = 0; i < 12000; i++) {
            seed = seed * 1664525u + 1013904223u;
            t = insert(t, seed >> 14);
        }
        for (i = 0; i < 20; i++)
            total += depth(t) + sum(t);
        destroy(t);
    }
    printf("tree %ld\n", total);
    return 0;
}
