/* Jumps out of recursion, out of calls through pointers and out of the library. */
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>

static jmp_buf env;
static int compared;

static int descend(int n)
{
    char room[40];

    room[n % 40] = n;
    if (n == 0)
        longjmp(env, 0);
    return descend(n - 1) + room[n % 40];
}

static int compare(const void *a, const void *b)
{
    if (++compared == 5)
        longjmp(env, compared * 100);
    return *(const int *)a - *(const int *)b;
}

static void by_pointer(void (*jump)(jmp_buf, int), jmp_buf where, int value)
{
    jump(where, value);
}

static int ackermann(jmp_buf out, int m, int n, int left)
{
    if (left == 0)
        longjmp(out, m * 1000 + n);
    if (m == 0)
        return n + 1;
    if (n == 0)
        return ackermann(out, m - 1, 1, left - 1);
    return ackermann(out, m - 1, ackermann(out, m, n - 1, left - 1), left - 1);
}

int main(void)
{
    int values[] = {5, 3, 9, 1, 7, 2, 8}, i, code;
    jmp_buf *heap = malloc(sizeof *heap);

    printf("%d\n", (code = setjmp(env)) == 0 ? descend(1000) : code);
    code = setjmp(env);
    if (code == 0)
        qsort(values, 7, sizeof *values, compare);
    printf("after %d comparisons: %d\n", compared, code);
    for (i = 0; i < 3; i++) {
        code = setjmp(*heap);
        if (code < 5)
            by_pointer(longjmp, *heap, code + 3);
        printf("%d: %d\n", i, code);
    }
    for (i = 1; i < 60; i += 7)
        if ((code = setjmp(env)) != 0)
            printf("%d gives %d\n", i, code);
        else
            printf("%d ends %d\n", i, ackermann(env, 2, 3, i));
    free(heap);
    return 0;
}
