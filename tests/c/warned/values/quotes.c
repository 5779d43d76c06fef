/* Characters in double quotes, strings in single quotes. */
int main(void)
{
    char c = "x"; // warning: use single quotes for a character
//           ^
    char *s = 'x'; // warning: use double quotes for a string
//            ^
    return c + *s;
}
