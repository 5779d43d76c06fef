/* Invalid uses of GNU extensions, and unsupported parts of C. */
struct flexible { int n; short v[]; };
union number { int i; double d; };

_Complex _Bool z; // error: '_Complex _Bool' is not a type
__int128 large; // error: type '__int128' is not supported
__uint128_t larger; // error: type '__uint128_t' is not supported
__float128 exact; // error: type '__float128' is not supported

int main(void)
{
    struct flexible f = {1, {2}}; // error: flexible array member of a local variable cannot be initialized
    union number n = (union number)"text"; // error: no member of 'union number' has the type 'char *'
    struct flexible g = (struct flexible)5; // error: used type 'struct flexible'
    int k = _Generic(n.i, int: 1, signed: 2, default: 3); // error: in generic association compatible with previous type
    k = _Generic(n.i, default: 1, default: 2); // error: duplicate default generic association
    (1 ? k : 2) = 3; // error: expression is not assignable
    return k;
}
