/* __label__ at the top of a function, __builtin_classify_type, gcc's builtin setjmp. */
#include <stdio.h>

static void *buffer[5];

static void back(void)
{
    __builtin_longjmp(buffer, 1);
}

int main(void)
{
    __label__ done;
    struct { int a; } s = {1};
    int i = 0;

    if (__builtin_setjmp(buffer) == 0) {
        i = 5;
        back();
    }
    printf("%d ", i);
    goto done;
    i = 1;
done:
    printf("%d\n", i);
    printf("%d %d %d %d\n", __builtin_classify_type(1), __builtin_classify_type(1.0f),
           __builtin_classify_type("x"), __builtin_classify_type(back));
    printf("%d %d\n", __builtin_classify_type((char)1), __builtin_classify_type(s));
    return 0;
}
