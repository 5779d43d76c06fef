/* A program that gdb and crs debug run alike: no robot, and no output. */
struct point {
    int x, y;
};

struct node {
    struct point at;
    struct node *next;
    char name[8];
};

enum colour { RED, GREEN = 5, BLUE };

struct node first = { { 1, 2 }, 0, "first" };
struct node second = { { 3, 4 }, &first, "second" };
int table[6] = { 1, 1, 2, 3, 5, 8 };
enum colour paint = GREEN;
double ratio = 0.25;
unsigned flags = 0xf0;
int calls;

static int twice(int n)
{
    calls++;
    return 2 * n;
}

static int add(int a, int b)
{
    int sum = a + b;
    calls++;
    return sum;
}

static int factorial(int n)
{
    int rest;
    if (n <= 1)
        return 1;
    rest = factorial(n - 1);
    return n * rest;
}

static char letter(int n)
{
    return 'a' + n;
}

static struct point moved(struct point from, int by)
{
    from.x += by;
    from.y -= by;
    return from;
}

static int total(const int *values, int count)
{
    int sum = 0;
    int i;
    for (i = 0; i < count; i++) {
        sum += values[i];
        table[i] = sum;
    }
    return sum;
}

static int length(const struct node *at)
{
    int n = 0;
    while (at) {
        n++;
        at = at->next;
    }
    return n;
}

int main(void)
{
    int a = 3;
    int b = 4;
    int (*op)(int) = twice;
    struct point here = { 7, 9 };
    a = twice(a) + add(a, b);
    b = factorial(5);
    a += op(b);
    here = moved(here, 2);
    b = letter(2);
    a += total(table, 6);
    b += length(&second);
    if (a > 100)
        flags |= 1;
    else
        flags &= 16;
    return a + b;
}
