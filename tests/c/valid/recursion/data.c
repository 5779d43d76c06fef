/* Recursion over data: binary trees, flood fill, subsets, quicksort. */
#include <stdio.h>

struct node { int key; struct node *left, *right; };

static struct node pool[16];
static int used;

static struct node *insert(struct node *t, int key)
{
    if (!t) {
        t = &pool[used++];
        t->key = key;
    } else if (key < t->key) {
        t->left = insert(t->left, key);
    } else {
        t->right = insert(t->right, key);
    }
    return t;
}

static int height(const struct node *t)
{
    int l, r;

    if (!t)
        return 0;
    l = height(t->left);
    r = height(t->right);
    return 1 + (l > r ? l : r);
}

static void walk(const struct node *t)
{
    if (t) {
        walk(t->left);
        printf("%d ", t->key);
        walk(t->right);
    }
}

static char map[5][9] = { "..#.....", ".##.###.", "....#...", "###.#.##", "....#..." };

static int fill(int i, int j)
{
    if (i < 0 || i > 4 || j < 0 || j > 7 || map[i][j] != '.')
        return 0;
    map[i][j] = 'o';
    return 1 + fill(i + 1, j) + fill(i - 1, j) + fill(i, j + 1) + fill(i, j - 1);
}

static int subsets(const int *v, int n, int target)
{
    if (n == 0)
        return target == 0;
    return subsets(v + 1, n - 1, target) + subsets(v + 1, n - 1, target - *v);
}

static void quicksort(int *v, int n)
{
    int i, last = 0, t;

    if (n < 2)
        return;
    for (i = 1; i < n; i++)
        if (v[i] < v[0])
            last++, t = v[last], v[last] = v[i], v[i] = t;
    t = v[0], v[0] = v[last], v[last] = t;
    quicksort(v, last);
    quicksort(v + last + 1, n - last - 1);
}

int main(void)
{
    int v[] = { 8, 3, 10, 1, 6, 14, 4, 7, 13 }, i;
    struct node *tree = 0;

    for (i = 0; i < 9; i++)
        tree = insert(tree, v[i]);
    walk(tree);
    printf("height %d\n", height(tree));
    printf("%d %d\n", fill(2, 2), fill(0, 0));
    for (i = 0; i < 5; i++)
        printf("%s\n", map[i]);
    printf("%d\n", subsets(v, 9, 20));
    quicksort(v, 9);
    for (i = 0; i < 9; i++)
        printf("%d ", v[i]);
    printf("\n");
    return 0;
}
