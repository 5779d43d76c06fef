/* Jumps in loops, several buffers in one function, buffers in structs, jumps to and fro. */
#include <setjmp.h>
#include <stdio.h>

struct task {
    int number;
    jmp_buf places[3];
};

static struct task tasks[2];
static jmp_buf loop_env;

static void go(int task, int place, int value)
{
    longjmp(tasks[task].places[place], value);
}

static void inner(struct task *task, int *trace)
{
    int value, i;

    for (i = 0; i < 3; i++) {
        value = setjmp(task->places[i]);
        *trace = *trace * 3 + value;
        if (value == 0 && i == 2)
            go(task->number, 1, 1);
        if (value == 1 && i == 2)
            go(task->number, 0, 2);
    }
}

static long spin(int rounds)
{
    volatile long sum = 0;
    int n = 0;

    if (setjmp(loop_env) < 2)
        sum = 1000000;
    do {
        sum += n;
        n++;
        if (n % 2)
            continue;
        if (n < rounds)
            longjmp(loop_env, n);
    } while (n < rounds);
    return sum;
}

/* No loop at all but the jump. */
static int without_loop(int times)
{
    int n = 0;

    setjmp(loop_env);
    if (++n < times)
        longjmp(loop_env, n);
    return n;
}

static int nested(int depth)
{
    jmp_buf mine;
    int got;

    if (depth == 0)
        return 1;
    got = setjmp(mine);
    if (got < depth && got < 3)
        longjmp(mine, got + 1);
    return got + 2 * nested(depth - 1);
}

int main(void)
{
    int trace = 0, i;

    for (i = 0; i < 2; i++) {
        tasks[i].number = i;
        inner(&tasks[i], &trace);
        printf("%d\n", trace);
    }
    printf("%ld\n", spin(200));
    printf("%d\n", without_loop(1000));
    printf("%d\n", nested(8));
    if (!setjmp(loop_env) && (i = 5))
        longjmp(loop_env, 1);
    while (setjmp(loop_env) < 3 && ++i)
        longjmp(loop_env, i & 3);
    printf("%d %d\n", i, !setjmp(loop_env));
    return 0;
}
