/* Labels, tags, members and ordinary names do not conflict (C17 6.2.3). */
#include <stdio.h>

typedef struct x { int x; struct { int x; } y; } y;
struct list { struct list *list; int next; };
enum tag { tag_zero, tag_one };
union other { int tag; int other; };

static int x(int x)
{
    if (x > 3)
        goto x;
    x++;
x:
    return x;
}

static int same(struct same { int same; } *same) { return same == 0; }

int main(void)
{
    struct x x1 = { 1, { 2 } };
    y y1 = { .x = 3, .y = { .x = 4 } };
    struct list list = { &list, 5 };
    enum tag tag = tag_one;
    union other other = { .tag = 6 };

    goto list;
list:
    printf("%d %d %d %d\n", x1.x, x1.y.x, y1.x, y1.y.x);
    printf("%d %d\n", x(1), x(9));
    printf("%d %d %d\n", list.list->list->next, tag, other.other);
    printf("%d\n", same(0));
    {
        typedef int printf_result;
        printf_result y = printf("inner ");
        struct y { char c; } z = { 'z' };
        printf("%d %c\n", y, z.c);
    }
    int main = 7;
    printf("%d\n", main);
    return 0;
}
