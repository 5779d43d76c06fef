/* A later initialiser for a subobject completely overrides the earlier one: omitted subobjects are zero. */
#include <stdio.h>

struct inner { int x; short y[3]; char text[6]; };
struct outer { int a; struct inner in[2]; int z[2][2]; };

static struct outer at_file_scope = {
    .in[1].y[0] = 5, .in[1] = { .x = 1 },
    .in[0] = { 1, { 2, 3 }, "abcde" }, .in[0].text = "z",
    .z = { { 1, 2 }, { 3, 4 } }, .z[1] = { 9 },
};

static void show(const struct outer *o)
{
    for (int i = 0; i < 2; i++) {
        printf("%d | %d %d %d |", o->in[i].x, o->in[i].y[0], o->in[i].y[1], o->in[i].y[2]);
        for (int k = 0; k < 6; k++)
            printf(" %d", o->in[i].text[k]);
        printf("\n");
    }
    printf("%d %d %d %d\n", o->z[0][0], o->z[0][1], o->z[1][0], o->z[1][1]);
}

int main(void)
{
    int three = 3;
    struct outer local = { .in[0].y = { 1, 2, three }, .in[0] = { .x = three }, .z[0][1] = 7 };
    struct inner value = { 8, { 8, 8, 8 }, "888" };
    struct outer part = { .in[0] = value, .in[1].x = 4, .in[1] = value };
    int rows[] = { [3] = 3, [1] = 1, 2, 33, [0] = 9 };

    show(&at_file_scope);
    show(&local);
    show(&part);
    for (int i = 0; i < 4; i++)
        printf("%d ", rows[i]);
    printf("%u\n", (unsigned) (sizeof rows / sizeof rows[0]));
    return 0;
}
