/* "Objects" of the 1990s: structs with functions, a table of them for each kind. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct shape;

struct methods {
    const char *name;
    double (*area)(const struct shape *);
    void (*grow)(struct shape *, double);
    int (*describe)(const struct shape *, char *, size_t);
};

struct shape {
    const struct methods *methods;
    struct shape *next;
    union {
        struct { double width, height; } box;
        struct { double radius; } circle;
    };
};

static double box_area(const struct shape *s) { return s->box.width * s->box.height; }
static double circle_area(const struct shape *s) { return 3 * s->circle.radius * s->circle.radius; }
static void box_grow(struct shape *s, double by) { s->box.width *= by; s->box.height *= by; }
static void circle_grow(struct shape *s, double by) { s->circle.radius *= by; }

static int describe(const struct shape *s, char *out, size_t size)
{
    return snprintf(out, size, "%s of %.2f", s->methods->name, s->methods->area(s));
}

static const struct methods box = { "box", box_area, box_grow, describe };
static const struct methods circle = { .describe = describe, .grow = circle_grow,
                                       .area = circle_area, .name = "circle" };

static struct shape *make(const struct methods *methods, double a, double b, struct shape *next)
{
    struct shape *s = calloc(1, sizeof *s);
    s->methods = methods;
    s->next = next;
    if (methods == &box) {
        s->box.width = a;
        s->box.height = b;
    } else
        s->circle.radius = a;
    return s;
}

static struct shape *reversed(struct shape *list)
{
    struct shape *back = NULL;
    while (list) {
        struct shape *next = list->next;
        list->next = back;
        back = list;
        list = next;
    }
    return back;
}

int main(void)
{
    struct shape *list = make(&box, 2, 3, make(&circle, 1.5, 0, make(&box, 1, 1, NULL)));
    char line[40];

    list = reversed(list);
    for (struct shape *s = list; s; s = s->next) {
        s->methods->grow(s, 2);
        int length = s->methods->describe(s, line, sizeof line);
        printf("%s (%d)\n", line, length);
    }
    while (list) {
        struct shape *next = list->next;
        free(list);
        list = next;
    }
    return 0;
}
