/* A tag is a struct, a union or an enum, and stays it. */
struct a { int n; };
union a; // error: use of 'a' with tag type that does not match its declaration
enum b { B };
struct b { int n; }; // error: use of 'b' with tag type that does not match its declaration

int main(void)
{
    struct a a = { 1 };
    return a.n;
}
