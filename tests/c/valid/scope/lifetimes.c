/* Lifetimes: automatic objects are created anew, static ones persist, each recursive call has its own automatic objects. */
#include <stdio.h>

static int *kept(void) { static int n = 10; n++; return &n; }

static int depth(int n)
{
    int own = n;
    static int calls;
    calls++;
    if (n > 0)
        depth(n - 1);
    return own * 100 + calls;
}

static int begun_anew(int turns)
{
    int sum = 0;
again:
    {
        int fresh = 5;
        sum += fresh++;
    }
    if (--turns)
        goto again;
    return sum;
}

static const char *text(int i)
{
    const char *texts[] = { "first", "second" };
    return texts[i];
}

int main(void)
{
    int *p = kept();
    int total = 0;

    ++*kept();
    printf("%d %d\n", *p, p == kept());
    printf("%d\n", depth(4));
    printf("%d\n", begun_anew(3));
    printf("%s %s\n", text(0), text(1));
    for (int i = 0; i < 3; i++) {
        int zero = 0, array[3] = { i };
        static int counted;
        zero += i;
        array[1] += zero;
        counted += array[0] + array[1] + array[2];
        total = counted;
    }
    printf("%d\n", total);
    return 0;
}
