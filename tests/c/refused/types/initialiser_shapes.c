/* Initialisers that do not fit what they initialise. */
struct s { int n; };
static int other = 5;
static int copied = other; // error: initializer element is not a compile-time constant
static char text[3] = 65; // error: array initializer must be an initializer list or string
static int numbers[2] = { [2] = 1 }; // error: array designator index (2) exceeds array bounds
static int negative[2] = { [-1] = 1 }; // error: array designator index (-1) exceeds array bounds
static struct s members = { .m = 1 }; // error: field designator 'm' does not refer to any field in type 'struct s'
static int called = sizeof(int) + abs(3); // error: initializer element is not a compile-time constant
extern int abs(int);

int main(void)
{
    int array[2] = numbers; // error: array initializer must be an initializer list or string
    struct s s = 5; // error: initializing 'struct s' with an expression of incompatible type 'int'
    int *p = { 1, 2 };
    return array[0] + s.n + *p;
}
