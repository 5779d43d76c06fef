/* Jumps without end out of the deepest recursion. */
// ends: running
// deep: 18,000 frames of this function
#include <setjmp.h>

static jmp_buf env;

static int descend(int depth)
{
    if (depth == 0)
        longjmp(env, 1);
    return descend(depth - 1) + 1;
}

static int again(int depth)
{
    if (depth > 0)
        return again(depth - 1) + 1;
    setjmp(env);
    return descend(5);
}

int main(void)
{
    return again(18000);
}
