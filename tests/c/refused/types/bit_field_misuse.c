/* Bit-fields have no address, no size, and fit their type. */
struct s { unsigned a : 3; };
struct too_wide { int b : 33; }; // error: width
struct negative { int c : -1; }; // error: bit-field 'c' has negative width
struct named_zero { int d : 0; }; // error: bit-field 'd' has zero width
struct of_double { double e : 3; }; // error: bit-field 'e' has non-integral type 'double'

int main(void)
{
    struct s s = { 1 };
    unsigned *p = &s.a; // error: bit-field
    return (int) sizeof(s.a) + *p; // error: bit-field
}
