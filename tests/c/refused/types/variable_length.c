/* Lengths that must be constant, and jumps past the declaration of a variable length array. */
static int n = 3;
int global[n]; // error: variable length array declaration not allowed at file scope
extern char text[2][n]; // error: variable length array declaration not allowed

struct holder {
    int count;
};

static int inside(int m)
{
    static int kept[m]; // error: variable length array 'kept' cannot be static
    int filled[m] = {1, 2}; // error: variable length array 'filled' cannot be initialized
    extern int far[m]; // error: object 'far' with variably modified type must have no linkage
    struct member { int v[m]; int w; };
    struct filled { int v[m]; } f = {{1}}; // error: variable length struct 'f' cannot be initialized
    struct bits { int v[m]; int b : 3; }; // error: bit-field beside a member of variable length
    struct unnamed { struct { int v[m]; }; }; // error: anonymous member beside a member of variable
    static struct member s; // error: variable length struct 's' cannot be static
    int passed(struct member t) { return t.w; } // error: 'struct member', whose size is variable
    struct member result(void); // error: function cannot return 'struct member', whose size is
    int *p = (int[m]){1}; // error: compound literal cannot be of variable length array type
    int star[*]; // error: star modifier used outside of a function prototype
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
