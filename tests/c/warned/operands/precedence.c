/* Operators that do not mean what they look like. */
int main(int argc, char **argv)
{
    int n = argc, flags = 3;

    if (0 < n < 10) // warning: comparisons like 'a < b < c' do not have their mathematical meaning
    //        ^
        return 1;
    if (n & 1 == 0) // warning: '&' has lower precedence than '==', which is evaluated first
    //    ^
        return 2;
    if (n != 2 | flags > 1) // warning: '|' has lower precedence than
        return 3;
    if ((n & 1) == 0 && (flags & (n == 1)) && (0 < n) < 2 && n < 5 == flags < 2)
        return 4;
    return argv == 0;
}
