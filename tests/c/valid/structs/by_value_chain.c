/* Structs as return values: members of call results, nested calls, structs that contain arrays, structs in conditional expressions. */
#include <stdio.h>

struct vec { double x, y; };
struct mat { double at[2][2]; };
struct small { char c; };
struct big { int n[20]; short tail; };

static struct vec vec(double x, double y) { return (struct vec) { x, y }; }
static struct vec add(struct vec a, struct vec b) { a.x += b.x; a.y += b.y; return a; }
static struct vec times(struct mat m, struct vec v)
{
    return vec(m.at[0][0] * v.x + m.at[0][1] * v.y, m.at[1][0] * v.x + m.at[1][1] * v.y);
}

static struct small small(char c) { struct small s = { c }; s.c++; return s; }

static struct big fill(struct big b, int from)
{
    for (int i = from; i < 20; i++)
        b.n[i] += i;
    b.tail = (short) from;
    return from > 15 ? b : fill(b, from + 5);
}

int main(void)
{
    struct mat turn = { { { 0, -1 }, { 1, 0 } } };
    struct vec v = vec(1, 2), w, many[2];
    struct big b = { { 0 } };
    int yes = 1;

    printf("%g %g\n", vec(3, 4).x, add(v, v).y);
    w = times(turn, times(turn, add(v, vec(10, 20))));
    printf("%g %g\n", w.x, w.y);
    printf("%c %c\n", small('a').c, small(small('x').c).c);
    b = fill(b, 0);
    printf("%d %d %d %d\n", b.n[4], b.n[9], b.n[19], b.tail);
    printf("%d %d\n", fill(b, 18).n[19], b.n[19]);
    many[0] = many[1] = w;
    many[1].x = (yes ? v : w).y;
    printf("%g %g\n", many[0].x, many[1].x);
    printf("%g\n", (many[0] = vec(5, 6)).y);
    printf("%d\n", fill(b, 3).n[fill(b, 16).tail]);
    printf("%g\n", times((struct mat) { { { 2 } } }, (struct vec) { .x = 21 }).x);
    return 0;
}
