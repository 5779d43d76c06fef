/* Objects made of structs with function pointers: shapes and a stream. */
#include <stdio.h>

struct shape;
struct shape_class {
    const char *name;
    double (*area)(const struct shape *);
    void (*scale)(struct shape *, double);
};
struct shape { const struct shape_class *class; double a, b; };

static double rectangle_area(const struct shape *s) { return s->a * s->b; }
static double disc_area(const struct shape *s) { return 3 * s->a * s->a; }
static void scale_both(struct shape *s, double k) { s->a *= k; s->b *= k; }
static void scale_first(struct shape *s, double k) { s->a *= k; }

static const struct shape_class rectangle = { "rectangle", rectangle_area, scale_both };
static const struct shape_class disc = { .scale = scale_first, .area = disc_area, .name = "disc" };

struct stream { int position; int (*next)(struct stream *); struct stream *from; };

static int count(struct stream *s) { return s->position++; }
static int squares(struct stream *s) { int n = s->from->next(s->from); return n * n; }
static int odd(struct stream *s)
{
    int n;
    while ((n = (*s->from->next)(s->from)) % 2 == 0)
        ;
    return n;
}

int main(void)
{
    struct shape shapes[] = { { &rectangle, 2, 3 }, { &disc, 1, 0 }, { &rectangle, 1, 1 } };
    struct stream numbers = { 3, count }, odds = { 0, odd, &numbers }, sq = { 0, squares, &odds };
    int i;

    for (i = 0; i < 3; i++) {
        shapes[i].class->scale(&shapes[i], i + 2);
        printf("%s %g\n", shapes[i].class->name, shapes[i].class->area(shapes + i));
    }
    for (i = 0; i < 5; i++)
        printf("%d ", sq.next(&sq));
    printf("\n");
    shapes[0].class = &disc;
    printf("%g\n", (shapes[0].class->area)(shapes));
    return 0;
}
