/* Structs and unions with variable-length members, which can be defined inside functions in GNU C. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

static int records(int n)
{
    struct record {
        char tag;
        short values[n];
        char name[n + 1];
        double weight;
        int grid[n][2];
    } one, *p = &one, all[n];
    int i, j, sum = 0;

    printf("%d %d %d\n", (int) sizeof one, (int) sizeof(struct record), (int) sizeof all);
    memset(&one, 0, sizeof one);
    one.tag = 'x';
    p->weight = 1.5;
    for (i = 0; i < n; i++) {
        one.values[i] = i * i;
        p->name[i] = 'a' + i;
        p->grid[i][1] = 10 * i;
        all[i] = one;
        all[i].weight += i;
    }
    for (p = all; p < all + n; p++) {
        sum += p->values[n - 1] + p->grid[n - 1][1];
        printf("%c %s %g %d\n", p->tag, p->name, p->weight, (int) (p - all));
    }
    p--;
    one = *p--;
    *p = *p;
    printf("%g %g %d\n", one.weight, p->weight, (int) ((char *) &p->weight - (char *) p));
    for (j = 0; j < 2; j++)
        one.grid[0][j] += p[0].grid[1][1]++;
    return sum + one.grid[0][1];
}

static void nested_types(int n)
{
    struct inner { int used; char text[n]; };
    typedef struct { struct inner in; int after; } Outer;
    union either { int number; char text[n]; short pair[2]; } u;
    Outer o, *q = &o;
    struct pointers { int (*row)[n]; int count; } r;
    int table[3][n];

    int length(struct inner *t) { return strlen(t->text) + t->used + sizeof *t + q->after; }

    strcpy(o.in.text, "text");
    q->in.used = 5;
    o.after = 100;
    printf("%d %d %d\n", length(&q->in), (int) sizeof(Outer), (int) sizeof u);
    u.number = 0;
    u.pair[1] = 0x4142;
    printf("%c%c %d\n", u.text[2], u.text[3], u.number);
    table[2][n - 1] = 7;
    r.row = table;
    r.count = 2;
    printf("%d %d\n", r.row[r.count][n - 1], (int) sizeof *r.row);
}

int main(void)
{
    int n;

    for (n = 2; n < 5; n++)
        printf("%d\n", records(n));
    nested_types(9);
    nested_types(12);
    return 0;
}
