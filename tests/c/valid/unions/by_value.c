/* Unions as arguments, results, members and array elements. */
#include <stdio.h>

union number { int i; float f; char text[8]; };
struct cell { char type; union number n; };

static struct cell integer(int i) { struct cell c = { 'i' }; c.n.i = i; return c; }
static struct cell real(float f) { return (struct cell) { 'f', { .f = f } }; }

static union number twice(union number n, char type)
{
    if (type == 'i')
        n.i *= 2;
    else
        n.f *= 2;
    return n;
}

static double as_double(struct cell c)
{
    return c.type == 'i' ? c.n.i : c.n.f;
}

int main(void)
{
    struct cell row[4] = { { 'i', { 5 } }, { 'f', { .f = 0.25f } } };
    union number texts[2] = { { .text = "alpha" }, { .text = { 'b', 0 } } };
    double sum = 0;
    int i;

    row[2] = integer(-8);
    row[3] = real(1.5);
    for (i = 0; i < 4; i++) {
        row[i].n = twice(row[i].n, row[i].type);
        sum += as_double(row[i]);
        printf("%g ", as_double(row[i]));
    }
    printf("%g\n", sum);
    texts[1] = texts[0];
    texts[0].text[0] = 'A';
    printf("%s %s\n", texts[0].text, texts[1].text);
    printf("%d %d\n", (int) sizeof(union number), (int) sizeof(struct cell));
    return 0;
}
