/* The same name declared several times, with increasingly complete types. */
#include <stdio.h>

int f();
int f(int, char *);
extern int array[];
extern int array[3];
int array[3] = { 1, 2, 3 };
extern int array[];
static int internal(void);
extern int internal(void);
static int tentative;
static int tentative = 4;
static int tentative;
int *pointer;
extern int *pointer;
const char *const names[];
const char *const names[] = { "a", "b" };
int (*table[])(void);
struct s;
extern struct s object;
struct s { int n; } object = { 5 };
typedef int number;
typedef int number;

int f(int n, char *s) { return n + s[0]; }
static int internal(void) { return 6; }
int (*table[])(void) = { internal };

int main(void)
{
    extern int array[];
    int f(int, char *);
    number n = 7;

    pointer = &array[2];
    printf("%d %d %u\n", f(1, "A"), *pointer, (unsigned) sizeof array);
    printf("%d %d %d %d %s\n", tentative, table[0](), object.n, n, names[1]);
    {
        int array = 9;
        {
            extern int array[];
            printf("%d ", array[1]);
        }
        printf("%d\n", array);
    }
    return 0;
}
