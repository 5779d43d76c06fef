/* Arrays as parameters are pointers: sizes, qualifiers, several dimensions, typedefs. */
#include <stdio.h>

typedef int triple[3];
typedef triple square[3];

static int size(int a[100]) { return (int) sizeof a; }
static int sum(const int a[static 2], int n) { return n ? a[n - 1] + sum(a, n - 1) : 0; }
static int corner(int a[][3], int n) { return a[n - 1][2]; }
static int diagonal(square s) { return s[0][0] + s[1][1] + s[2][2]; }
static void bump(triple t) { t[1]++; t++; t[1] = 70; }
static int whole(triple *t) { return (*t)[2] + (int) (sizeof *t / sizeof **t); }
static int words(const char *const list[]) { int n = 0; while (*list++) n++; return n; }
static int deep(int a[2][3][4]) { return a[1][2][3] + (int) sizeof a[0]; }
static void *same(int (*a)[3]) { return a; }

int main(void)
{
    square s = { { 1, 2, 3 }, { 4, 5, 6 }, { 7, 8, 9 } };
    int cube[2][3][4] = { [1][2][3] = 42 };
    const char *list[] = { "a", "b", "c", NULL };

    printf("%d %d\n", size(s[0]), sum(s[2], 3));
    printf("%d %d\n", corner(s, 3), diagonal(s));
    bump(s[0]);
    printf("%d %d %d\n", s[0][0], s[0][1], s[0][2]);
    printf("%d %d\n", whole(s + 1), whole(&s[2]));
    printf("%d %d\n", words(list), deep(cube));
    printf("%d %d\n", same(s) == s, (void *) s == (void *) &s[0][0]);
    return 0;
}
