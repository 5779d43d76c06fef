/* Mistakes in GNU C's additions, and builtins that make no sense here. */
void *far = &&nowhere; // error: address of a label used outside of a function body

struct s { int bits : 3; };

int main(void)
{
    struct s s;
    void *p = &&missing; // error: use of undeclared label 'missing'
    __auto_type empty; // error: '__auto_type' requires exactly one initializer
    typeof(s.bits) b; // error: invalid application of 'typeof' to bit-field
    int v[4] = {[3 ... 1] = 1}; // error: array designator range [3, 1] is empty
    int w[4] = {[2 ... 4] = 1}; // error: array designator index (4) exceeds array bounds
    int o = __builtin_add_overflow(1.5, 2, &o); // error: overflow of 'double' is not supported

    goto *s; // error: assigning to 'const void *' from incompatible type 'struct s'
    __builtin_frame_address(0); // error: '__builtin_frame_address' is not supported
    __sync_fetch_and_add(o, 1); // error: address argument to atomic builtin must be a pointer ('int' given)
    __sync_add(&o, 1); // error: '__sync_add' is not a known atomic builtin
    __builtin_choose_expr(o, 1, 2); // error: is not an integer constant expression
    switch (o) {
    case 1 ... 5:
    case 3: // error: duplicate case value '3'
    case 0 ... 1: // error: duplicate case value '1'
        break;
    }
    return 0;
}
