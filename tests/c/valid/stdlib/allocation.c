/* malloc, calloc, realloc, free: many blocks, growth, contents kept, alignment. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct node { int value; struct node *next; };

static struct node *push(struct node *list, int value)
{
    struct node *n = malloc(sizeof *n);

    n->value = value;
    n->next = list;
    return n;
}

static struct node *reverse(struct node *list)
{
    struct node *done = NULL, *next;

    for (; list; list = next) {
        next = list->next;
        list->next = done;
        done = list;
    }
    return done;
}

int main(void)
{
    struct node *list = NULL, *n;
    int *v = NULL, *zeroed, i, size = 0, sum = 0, ok = 1;
    char *blocks[50];

    for (i = 0; i < 10; i++)
        list = push(list, i * i);
    list = reverse(list);
    for (n = list; n; n = n->next)
        printf("%d ", n->value);
    printf("\n");
    while (list) {
        n = list->next;
        free(list);
        list = n;
    }
    for (i = 0; i < 500; i++) {
        if (i == size)
            v = realloc(v, (size = size ? size * 2 : 4) * sizeof *v);
        v[i] = i;
    }
    for (i = 0; i < 500; i++)
        sum += v[i];
    printf("%d %d\n", size, sum);
    v = realloc(v, 10 * sizeof *v);
    printf("%d\n", v[9]);
    free(v);
    zeroed = calloc(300, sizeof *zeroed);
    for (i = 0; i < 300; i++)
        ok &= zeroed[i] == 0;
    free(zeroed);
    for (i = 0; i < 50; i++) {
        blocks[i] = malloc(i * 3 + 1);
        memset(blocks[i], i, i * 3 + 1);
        ok &= (unsigned long) blocks[i] % 8 == 0;
    }
    for (i = 0; i < 50; i += 2)
        free(blocks[i]);
    for (i = 0; i < 50; i += 2)
        memset(blocks[i] = malloc(i * 5 + 1), i, i * 5 + 1);
    for (i = 0; i < 50; i++)
        ok &= blocks[i][0] == i && blocks[i][i * 3] == i;
    for (i = 0; i < 50; i++)
        free(blocks[i]);
    free(NULL);
    printf("%d\n", ok);
    return 0;
}
