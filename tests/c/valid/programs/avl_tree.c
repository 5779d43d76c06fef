/* A balanced tree on the heap, with rotations, deletion and freeing. */
#include <stdio.h>
#include <stdlib.h>

typedef struct tree { int key, height; struct tree *side[2]; } Tree;

static int height(const Tree *t) { return t ? t->height : 0; }

static void update(Tree *t)
{
    int a = height(t->side[0]), b = height(t->side[1]);
    t->height = 1 + (a > b ? a : b);
}

static Tree *rotate(Tree *t, int to)
{
    Tree *up = t->side[!to];

    t->side[!to] = up->side[to];
    up->side[to] = t;
    update(t);
    update(up);
    return up;
}

static Tree *balance(Tree *t)
{
    int side;

    update(t);
    for (side = 0; side < 2; side++)
        if (height(t->side[side]) - height(t->side[!side]) > 1) {
            Tree *s = t->side[side];
            if (height(s->side[!side]) > height(s->side[side]))
                t->side[side] = rotate(s, side);
            return rotate(t, !side);
        }
    return t;
}

static Tree *insert(Tree *t, int key)
{
    if (!t) {
        t = calloc(1, sizeof *t);
        t->key = key;
        t->height = 1;
        return t;
    }
    if (key != t->key)
        t->side[key > t->key] = insert(t->side[key > t->key], key);
    return balance(t);
}

static Tree *erase(Tree *t, int key)
{
    if (!t)
        return NULL;
    if (key == t->key) {
        if (t->side[0] && t->side[1]) {
            Tree *next = t->side[1];
            while (next->side[0])
                next = next->side[0];
            t->key = next->key;
            t->side[1] = erase(t->side[1], next->key);
        } else {
            Tree *child = t->side[0] ? t->side[0] : t->side[1];
            free(t);
            return child;
        }
    } else {
        t->side[key > t->key] = erase(t->side[key > t->key], key);
    }
    return balance(t);
}

static int check(const Tree *t, int low, int high)
{
    if (!t)
        return 1;
    return t->key > low && t->key < high && abs(height(t->side[0]) - height(t->side[1])) < 2
        && check(t->side[0], low, t->key) && check(t->side[1], t->key, high);
}

static void print(const Tree *t)
{
    if (!t)
        return;
    printf("(");
    print(t->side[0]);
    printf("%d", t->key);
    print(t->side[1]);
    printf(")");
}

int main(void)
{
    Tree *t = NULL;
    int i;

    for (i = 1; i <= 15; i++)
        t = insert(t, i);
    print(t);
    printf(" %d\n", height(t));
    for (i = 0; i < 60; i++)
        t = insert(t, i * 37 % 61 + 100);
    printf("%d %d\n", height(t), check(t, -1, 1000));
    for (i = 0; i < 60; i += 2)
        t = erase(t, i * 37 % 61 + 100);
    for (i = 1; i <= 15; i += 3)
        t = erase(t, i);
    printf("%d %d\n", height(t), check(t, -1, 1000));
    while (t)
        t = erase(t, t->key);
    printf("%d\n", height(t));
    return 0;
}
