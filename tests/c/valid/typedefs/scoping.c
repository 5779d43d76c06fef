/* A typedef name can be hidden by a variable, parameter or member in an inner scope. */
#include <stdio.h>

typedef int number;
typedef char *text, letter;
typedef struct pair { number first; text second; } pair, *pair_pointer;
typedef number row[3];
typedef number (*operation)(number, number);

static number add(number a, number b) { return a + b; }

static number hidden(number number)
{
    return number * 2;
}

static int member(void)
{
    struct { int number; letter text; } s = { 4, 'x' };
    return s.number + s.text;
}

int main(void)
{
    number n = 3;
    text t = "typed";
    pair p = { 1, "one" };
    pair_pointer q = &p;
    row r = { 7, 8, 9 }, rows[2] = { { 1, 2, 3 }, { 4, 5, 6 } };
    operation f = add;

    printf("%d %s %c\n", n, t, *t);
    {
        int pair = 5;
        typedef double number;
        number x = 0.5;
        printf("%d %g %d\n", pair, x, (int) sizeof(number));
    }
    {
        number text = 9;
        letter number = 'n';
        text *= 2;
        printf("%d %c\n", text, number);
    }
    printf("%s %d\n", q->second, f(q->first, r[2]));
    printf("%d %d\n", rows[1][2], (int) (sizeof(row) / sizeof(number)));
    printf("%d %d\n", hidden(21), member());
    for (int number = 0; number < 2; number++)
        printf("%d ", number);
    printf("%d\n", (number) 3.9);
    return 0;
}
