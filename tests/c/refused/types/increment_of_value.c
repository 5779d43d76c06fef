/* ++ and -- want a place. */
int main(void)
{
    int a = 1, b = 2;
    (a + b)++; // error: expression is not assignable
    ++a++; // error: expression is not assignable
    --5; // error: expression is not assignable
    return 0;
}
