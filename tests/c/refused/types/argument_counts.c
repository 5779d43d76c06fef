/* Calls that do not match the called function. */
static int one(int n) { return n; }
static int format(const char *text, ...) { return text[0]; }
static void nothing(void) { }
struct s { int n; };

int main(void)
{
    struct s s = { 1 };
    int n = 0;

    n = one(); // error: too few
    n = one(1, 2); // error: too many
    n = one(s); // error: passing 'struct s' to parameter of incompatible type 'int'
    n = format(); // error: too few
    n = nothing(); // error: assigning to 'int' from incompatible type 'void'
    n = n(1); // error: called object type 'int' is not a function or function pointer
    n = one(nothing()); // error: argument type 'void' is incomplete
    return n;
}
