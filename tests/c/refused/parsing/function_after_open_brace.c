/* A missing brace makes the next function a nested one. */
int twice(int n)
{
    if (n > 0) {
        return 2 * n;
}
int main(void)
{   // error: function definition is not allowed here
    return twice(2);
}
