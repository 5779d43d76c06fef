/* A character that C does not know. */
int main(void)
{
    int price = 5 @ 2; // error: 
    return price;
}
