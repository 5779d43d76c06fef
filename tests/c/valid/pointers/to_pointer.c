/* Pointers to pointers: rows, out parameters, linked list surgery. */
#include <stdio.h>
#include <string.h>

struct node { int value; struct node *next; };

static void first_word(const char *text, const char **begin, const char **end)
{
    while (*text == ' ')
        text++;
    *begin = text;
    while (*text && *text != ' ')
        text++;
    *end = text;
}

static void swap(int **a, int **b)
{
    int *t = *a;
    *a = *b;
    *b = t;
}

static void remove_value(struct node **link, int value)
{
    while (*link) {
        if ((*link)->value == value)
            *link = (*link)->next;
        else
            link = &(*link)->next;
    }
}

int main(void)
{
    int x = 1, y = 2, *px = &x, *py = &y, **pp = &px, ***ppp = &pp;
    const char *begin, *end;
    char *rows[3] = { "one", "two", "three" }, **row;
    struct node n[5] = { { 1, n + 1 }, { 2, n + 2 }, { 1, n + 3 }, { 3, n + 4 }, { 1, 0 } };
    struct node *list = n, *p;

    ***ppp = 10;
    *pp = py;
    **pp = 20;
    printf("%d %d %d\n", x, y, *px);
    swap(&px, &py);
    printf("%d %d\n", *px, *py);
    swap(pp = &py, &px);
    first_word("  hello world", &begin, &end);
    printf("%.*s %d\n", (int) (end - begin), begin, (int) strlen(end));
    for (row = rows; row < rows + 3; row++)
        printf("%s %c ", *row, *(*row + 1));
    printf("\n");
    remove_value(&list, 1);
    for (p = list; p; p = p->next)
        printf("%d ", p->value);
    printf("\n");
    return 0;
}
