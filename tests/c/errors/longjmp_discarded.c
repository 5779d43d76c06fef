/* The function that called setjmp was exited by another longjmp. */
#include <setjmp.h>

static jmp_buf outer, inner;

static void leave(void)
{
    if (setjmp(inner) == 0)
        longjmp(outer, 1);
}

int main(void)
{
    if (setjmp(outer) == 0)
        leave();
    longjmp(inner, 1); // error: longjmp to a function that has returned
}
