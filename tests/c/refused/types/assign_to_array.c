/* Assignment to an array. */
int main(void)
{
    char text[6], other[6] = "hello";

    text = other; // error: array
    return text[0];
}
