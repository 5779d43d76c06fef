/* Numbers and characters that no type can represent. */
int main(void)
{
    int a = 99999999999999999999; // error: integer constant 99999999999999999999 is too large for any type
    int b = '\xfff'; // error: escape sequence out of range
    char c[] = "\400"; // error: escape sequence out of range
    return a + b + c[0];
}
