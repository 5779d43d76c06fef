/* Static assertions that fail, with and without a message. */
struct s { char c; int n; _Static_assert(sizeof(int) == 4, "fine"); };
_Static_assert(sizeof(struct s) == 5, "no padding here"); // error: no padding here
_Static_assert(1 == 1, "true");

int main(void)
{
    _Static_assert(sizeof(long) == 8); // error: static assertion failed
    return 0;
}
