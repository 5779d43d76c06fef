/* setjmp and longjmp: out of calls, retries, nested handlers. */
#include <stdio.h>
#include <setjmp.h>

static jmp_buf top, *handler;

static void fail(int code)
{
    longjmp(*handler, code);
}

static int divide(int a, int b)
{
    if (b == 0)
        fail(7);
    return a / b;
}

static int guarded(int a, int b)
{
    jmp_buf here, *outer = handler;
    volatile int result = -1;

    if (setjmp(here) == 0) {
        handler = &here;
        result = divide(a, b);
    }
    handler = outer;
    return result;
}

int main(void)
{
    volatile int tries = 0;
    int code;

    handler = &top;
    code = setjmp(top);
    printf("code %d tries %d\n", code, tries);
    if (tries++ < 2)
        fail(tries + 10);
    printf("%d %d\n", guarded(10, 2), guarded(1, 0));
    switch (setjmp(top)) {
    case 0:
        divide(1, 0);
        printf("never\n");
        break;
    case 7:
        printf("caught\n");
    }
    return 0;
}
