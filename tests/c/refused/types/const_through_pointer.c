/* const objects cannot be assigned to, including through pointers, members and elements. */
struct s { const int fixed; int free; };

int main(void)
{
    const int table[2] = { 1, 2 };
    const char *text = "abc";
    struct s s = { 1, 2 };
    const struct s t = { 3, 4 };
    int n = 0;
    int *const pointer = &n;

    table[0] = 5; // error: cannot assign to read-only location with const-qualified type 'const int'
    *text = 'x'; // error: cannot assign to read-only location with const-qualified type 'const char'
    s.fixed++; // error: cannot assign to member 'fixed' with const-qualified type 'const int'
    t.free = 1; // error: cannot assign to member 'free' with const-qualified type 'const int'
    pointer = 0; // error: cannot assign to variable 'pointer' with const-qualified type 'int *const'
    *pointer = 1;
    return s.free;
}
