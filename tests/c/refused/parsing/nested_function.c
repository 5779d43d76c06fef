/* Nested functions. */
int main(void)
{
    int twice(int n) { return 2 * n; } // error: function definition is not allowed here
    return twice(2);
}
