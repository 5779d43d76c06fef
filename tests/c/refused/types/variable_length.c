/* Lengths that must be constant, and jumps past the declaration of a variable length array. */
static int n = 3;
int global[n]; // error: array length is not constant, but outside of functions
extern char text[2][n]; // error: array length is not constant

struct holder {
    int count;
};

static int inside(int m)
{
    static int kept[m]; // error: 'kept' cannot be static: its length is not constant
    int filled[m] = {1, 2}; // error: 'filled' cannot be given an initial value
    extern int far[m]; // error: 'far' is known to other functions
    struct member { int v[m]; }; // error: member 'v' has a length that is not constant
    int *p = (int[m]){1}; // error: a compound literal's length must be constant
    int star[*]; // error: '[*]' outside of a function declaration's parameters
    int wrong[2.5 * m]; // error: size of array has non-integer type 'double'
    int unknown[q]; // error: use of undeclared identifier 'q'
    return m;
}

static int jumps(int m)
{
    if (m > 3)
        goto later; // error: 'goto' jumps into the scope of 'v'
    int v[m];
later:
    switch (m) {
        char w[m];
    case 1: // error: 'switch' jumps into the scope of 'w'
        return w[0];
    }
    goto pointer; // error: 'goto' jumps into the scope of 'p'
    {
        int (*p)[m] = 0;
    pointer:
        return p == 0;
    }
}

int main(void)
{
    return inside(2) + jumps(3);
}
