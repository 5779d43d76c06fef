/* All kinds of assignable expressions. */
#include <stdio.h>

struct box { int n; int row[3]; struct { char c; } in; };
static struct box boxes[2];
static int *find(int i) { return &boxes[1].row[i]; }
static struct box *which(int i) { return boxes + i; }

int main(void)
{
    int x = 1, *p = &x, **pp = &p, a[3] = { 0 };
    struct box box = { 0 };
    char text[] = "abc";

    *p = 2;
    **pp += 3;
    a[1] = a[2] = x;
    2[a]++;
    *(a + 0) = 9;
    printf("%d %d %d %d\n", x, a[0], a[1], a[2]);
    box.row[1] = 4;
    (&box)->in.c = 'q';
    (*&box).n = box.row[1]++;
    (box).row[2] = 7;
    printf("%d %d %d %c\n", box.n, box.row[1], box.row[2], box.in.c);
    *find(2) = 11;
    find(0)[1] = 12;
    which(1)->n = 13;
    which(0)[1].in.c = 'z';
    (*which(0)) = box;
    printf("%d %d %d %c %d\n", boxes[1].row[2], boxes[1].row[1], boxes[1].n, boxes[1].in.c, boxes->n);
    *text = 'A';
    text[1] ^= ' ';
    *(char *) (text + 2) = '!';
    "xyz"[0];
    printf("%s %c\n", text, *("hello" + 4));
    *(*pp = a) = 77;
    (x > 0 ? a : &x)[1] = 78;
    printf("%d %d\n", a[0], a[1]);
    return 0;
}
