/* Characters and strings in each other's quotes. */
int main(void)
{
    char c = "x"; // warning: use single quotes for a character
//           ^
    char *s = 'x'; // warning: use double quotes for a string
//            ^
    return c + *s;
}
