/* Arguments may be empty, contain commas in parentheses, and span lines. */
#include <stdio.h>

#define NONE() 5
#define ONE(x) [x]
#define TWO(x, y) (x 1 y)
#define COUNT(...) COUNT_(__VA_ARGS__, 5, 4, 3, 2, 1)
#define COUNT_(a, b, c, d, e, n, ...) n
#define SHOW(...) printf(__VA_ARGS__)
#define LOG(format, ...) printf("log: " format "\n", ##__VA_ARGS__)
#define STRINGS(...) #__VA_ARGS__
#define NAMED(args...) sum(args)
#define FIRST(a, ...) a
#define REST(a, ...) __VA_ARGS__

static int sum(int a, int b, int c) { return a + b + c; }

int main(void)
{
    int a ONE() = { 1, 2 };
    int b ONE(2) = { 3, 4 };

    printf("%d %d %d\n", a[1], b[1], NONE());
    printf("%d %d %d %d\n", TWO(,), TWO(-,), TWO(, - 3), TWO(2 -, + 4));
    printf("%d %d %d\n", COUNT(1), COUNT(1, 2, 3), COUNT((1, 2), (3, 4)));
    SHOW("%d %s\n",
         3,
#define INNER "inner"
         INNER);
    LOG("nothing");
    LOG("%d and %s", 1, "two");
    puts(STRINGS(a, "b,c" , (d , e)));
    puts(STRINGS());
    printf("%d\n", NAMED(1, 2, 3));
    printf("%d %d\n", FIRST(7, 8, 9), sum(REST(7, 8, 9, 10)));
    printf("%d\n", sum
           (1,
            2, 3));
    return 0;
}
