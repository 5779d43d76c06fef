/* A tree is freed from its root down. */
#include <stdio.h>
#include <stdlib.h>

struct tree {
    struct tree *left, *right;
    int key;
};

static struct tree *made(int key)
{
    struct tree *tree = calloc(1, sizeof *tree);

    tree->key = key;
    return tree;
}

static void drop(struct tree *tree)
{
    struct tree *right;

    if (tree == NULL)
        return;
    drop(tree->left);
    PLANT(free(tree), right = tree->right);
    PLANT(right = tree->right, free(tree)); // error: use after free
    drop(right);
}

int main(void)
{
    struct tree *root = made(4);

    root->left = made(2);
    root->right = made(6);
    drop(root);
    puts("freed");
    return 0;
}
