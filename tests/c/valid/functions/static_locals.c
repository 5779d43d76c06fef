/* Static locals live as long as the program and are initialised once. */
#include <stdio.h>

static int counter(void)
{
    static int n = 10;
    return n++;
}

static int other(void)
{
    static int n;
    return --n;
}

static const char *ring(int n)
{
    static char buffers[3][12];
    static int next;
    char *b = buffers[next++ % 3];

    sprintf(b, "<%d>", n);
    return b;
}

static int fibonacci(int n)
{
    static int cache[40] = { 0, 1 };

    if (n > 1 && !cache[n])
        cache[n] = fibonacci(n - 1) + fibonacci(n - 2);
    return cache[n];
}

static int *shared(void)
{
    static int cell = 3;
    return &cell;
}

int main(void)
{
    int i;

    for (i = 0; i < 3; i++)
        printf("%d %d ", counter(), other());
    printf("\n");
    printf("%s %s %s\n", ring(1), ring(2), ring(3));
    printf("%d %d\n", fibonacci(39), fibonacci(20));
    *shared() += 4;
    printf("%d\n", *shared());
    for (i = 0; i < 3; i++) {
        static int seen = 100;
        int fresh = 100;
        seen++;
        fresh++;
        printf("%d %d ", seen, fresh);
    }
    printf("\n");
    return 0;
}
