/* Binary search trees (POSIX tsearch). A tree that is built in order is a list: they are not
   balanced, and nothing but the speed shows it. */
#include <search.h>
#include <stdlib.h>

struct node {
    const void *key;            /* first, so that a node can be used as a pointer to the key */
    struct node *left, *right;
};

typedef int (*comparison)(const void *, const void *);

/* Returns the place of the pointer to a key's node, or of the null pointer where it belongs. */
static struct node **place_of(const void *key, struct node **at, comparison compare)
{
    int order;

    while (*at != NULL && (order = compare(key, (*at)->key)) != 0)
        at = order < 0 ? &(*at)->left : &(*at)->right;
    return at;
}

void *tsearch(const void *key, void **root, comparison compare)
{
    struct node **at;

    if (root == NULL)
        return NULL;
    at = place_of(key, (struct node **)root, compare);
    if (*at == NULL && (*at = calloc(1, sizeof **at)) != NULL)
        (*at)->key = key;
    return *at;
}

void *tfind(const void *key, void *const *root, comparison compare)
{
    return root == NULL ? NULL : *place_of(key, (struct node **)root, compare);
}

/* Returns the parent of the deleted node; for the root some pointer that is not null. */
void *tdelete(const void *key, void **root, comparison compare)
{
    struct node **at = (struct node **)root, *parent = NULL, *found, *next;
    int order;

    if (root == NULL)
        return NULL;
    while (*at != NULL && (order = compare(key, (*at)->key)) != 0) {
        parent = *at;
        at = order < 0 ? &parent->left : &parent->right;
    }
    found = *at;
    if (found == NULL)
        return NULL;
    if (found->right == NULL) {
        *at = found->left;
    } else {
        struct node **least = &found->right;
        while ((*least)->left != NULL)
            least = &(*least)->left;
        next = *least;
        *least = next->right;
        next->left = found->left;
        next->right = found->right;
        *at = next;
    }
    free(found);
    return parent == NULL ? (void *)root : parent;
}

static void walk(const struct node *node, void (*act)(const void *, VISIT, int), int depth)
{
    if (node->left == NULL && node->right == NULL) {
        act(node, leaf, depth);
        return;
    }
    act(node, preorder, depth);
    if (node->left != NULL)
        walk(node->left, act, depth + 1);
    act(node, postorder, depth);
    if (node->right != NULL)
        walk(node->right, act, depth + 1);
    act(node, endorder, depth);
}

void twalk(const void *root, void (*act)(const void *, VISIT, int))
{
    if (root != NULL)
        walk(root, act, 0);
}

static void destroy(struct node *node, void (*release)(void *))
{
    if (node == NULL)
        return;
    destroy(node->left, release);
    destroy(node->right, release);
    release((void *)node->key);
    free(node);
}

void tdestroy(void *root, void (*release)(void *))
{
    destroy(root, release);
}
