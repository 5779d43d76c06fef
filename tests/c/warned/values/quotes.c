/* Characters in double quotes, strings in single quotes. */
int main(void)
{
    char c = "x"; // warning: a single character stands in single quotes
//           ^
    char *s = 'x'; // warning: a string stands in double quotes
//            ^
    return c + *s;
}
