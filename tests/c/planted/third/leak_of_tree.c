/* Only the root of a tree is freed. */
#include <stdlib.h>
struct node { struct node *left, *right; int key; };
static struct node *make(int depth)
{
    struct node *n = malloc(sizeof *n); // leak: 6
    n->key = depth;
    n->left = n->right = 0;
    if (depth > 0) {
        n->left = make(depth - 1);
        n->right = make(depth - 1);
    }
    return n;
}
static void drop(struct node *n)
{
    if (n && PLANT(n->key == 2, 1)) {
        drop(n->left);
        drop(n->right);
        free(n);
    }
}
int main(void)
{
    struct node *root = make(2);
    drop(root);
    root = 0;
    return 0;
}
